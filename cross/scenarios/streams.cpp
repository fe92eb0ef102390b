// Scenarios of streams.
#include "scenarios.hpp"
#include "solids.hpp"

namespace osem::cross {

namespace {

// A sink that keeps what fits and digests everything.
struct Bytes {
    std::uint8_t kept[600];
    std::size_t count;
    Digest digest;
};

bool take(void* context, const std::uint8_t* bytes, std::size_t count) {
    Bytes& to = *static_cast<Bytes*>(context);
    for (std::size_t i = 0; i < count; ++i) {
        if (to.count < sizeof to.kept) to.kept[to.count] = bytes[i];
        ++to.count;
        to.digest.add_byte(bytes[i]);
    }
    return true;
}

Bytes bytes;

// The bits of the binary64 numbers -1.5, 0, 1 and 0.1: the kernel carries them unread.
constexpr std::uint64_t frame_words[4] = {0xbff8000000000000U, 0, 0x3ff0000000000000U, 0x3fb999999999999aU};

Status write(const Octree& tree) {
    StreamHeader header = {};
    for (int i = 0; i < 4; ++i) header.frame[i] = frame_words[i];
    bytes.count = 0;
    bytes.digest = Digest();
    return write_stream(tree, header, Sink{take, &bytes});
}

void add(Digest& digest, const StreamOutcome& outcome) {
    digest.add(outcome.built.status);
    digest.add(outcome.built.nodes_needed);
    digest.add(outcome.offset);
    if (outcome.built.status == Status::ok) digest.add(osem::digest(outcome.built.tree));
}

StreamOutcome read_kept(StreamReader& reader) {
    reader.begin(&pool);
    reader.feed(bytes.kept, bytes.count);
    return reader.finish();
}

} // namespace

std::uint64_t stream_bytes() {
    Digest digest;
    auto& reader = fresh<StreamReader>();
    ConvertOptions options;
    for (options.depth = 1; options.depth <= 5; ++options.depth) {
        pool.roll_back(0);
        digest.add(write(converted(octahedron(), options).tree));
        digest.add(static_cast<std::uint64_t>(bytes.count));
        digest.add(bytes.digest.value());
        if (bytes.count > sizeof bytes.kept) continue;
        add(digest, read_kept(reader));
        for (const std::uint64_t word : reader.header().frame) digest.add(word);
    }
    return digest.value();
}

// Every byte of a stream changed, and the stream cut off before it.
std::uint64_t damaged_streams() {
    Digest digest;
    auto& reader = fresh<StreamReader>();
    ConvertOptions options;
    options.depth = 3;
    write(converted(octahedron(), options).tree);
    const std::size_t whole = bytes.count;
    digest.add(static_cast<std::uint64_t>(whole));
    for (std::size_t at = 0; at < whole; ++at) {
        const std::uint8_t right = bytes.kept[at];
        bytes.kept[at] = static_cast<std::uint8_t>(right ^ (1U << (at % 8)));
        pool.roll_back(0);
        add(digest, read_kept(reader));
        bytes.kept[at] = right;
        bytes.count = at;
        add(digest, read_kept(reader));
        digest.add(pool.used());
        bytes.count = whole;
    }
    return digest.value();
}

namespace {

// A stream of its own beside the job that combines it with the one kept.
struct TwoStreams {
    StreamCombination job;
    std::uint8_t first[sizeof bytes.kept];
    std::size_t count;
};

void add(Digest& digest, const StreamCombinationOutcome& outcome) {
    digest.add(outcome.status);
    digest.add(static_cast<std::uint64_t>(outcome.operand));
    digest.add(outcome.offset);
    digest.add(std::uint64_t{outcome.header.nodes});
}

bool take_digest(void* context, const std::uint8_t* from, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) static_cast<Digest*>(context)->add_byte(from[i]);
    return true;
}

void add_answers(Digest& digest, const Source& source) {
    const StreamMeasures measured = measure(source);
    digest.add(measured.status);
    digest.add(measured.measures.inner_volume);
    digest.add(measured.measures.outer_volume);
    digest.add(osem::digest(source).digest);
    const StreamPointOutcome outcome = leaf_at(source, Point{{root_side / 3, root_side / 2, root_side / 3}});
    digest.add(outcome.point.leaf.colour);
    digest.add(std::uint64_t{outcome.point.visited});
    digest.add(outcome.offset);
}

// The first stream beside the job, the second one kept.
TwoStreams& written_streams() {
    ConvertOptions options;
    options.depth = 3;
    TwoStreams& two = fresh<TwoStreams>();
    write(converted(octahedron(), options).tree);
    two.count = bytes.count;
    for (std::size_t i = 0; i < two.count; ++i) two.first[i] = bytes.kept[i];
    pool.roll_back(0);
    options.depth = 2;
    write(converted(plate(), options).tree);
    return two;
}

} // namespace

// Two streams asked, compared and combined by every operator; then a byte of the second one changes.
std::uint64_t combined_streams() {
    Digest digest;
    TwoStreams& two = written_streams();
    const Source a = memory_source(two.first, two.count);
    const Source b = memory_source(bytes.kept, bytes.count);
    const Sink sink = {take_digest, &digest};
    add_answers(digest, a);
    add_answers(digest, b);
    digest.add(std::uint64_t{same_leaves(a, b).same});
    for (int round = 0; round < 2; ++round) {
        for (int op = 0; op < 4; ++op) add(digest, combine(two.job, static_cast<Operator>(op), a, b, sink));
        add(digest, complement(two.job, b, sink));
        std::uint8_t& middle = bytes.kept[bytes.count / 2];
        middle = static_cast<std::uint8_t>(middle ^ 4U);
    }
    return digest.value();
}

// The same, both streams checked and indexed before: the index, and what is found and made with it.
std::uint64_t indexed_streams() {
    Digest digest;
    TwoStreams& two = written_streams();
    std::uint8_t index_a[sizeof two.first / 32];
    std::uint8_t index_b[sizeof bytes.kept / 32];
    const StreamCheckOutcome a = check_stream(memory_source(two.first, two.count), index_a, sizeof index_a);
    const StreamCheckOutcome b =
        check_stream(memory_source(bytes.kept, bytes.count), index_b, sizeof index_b);
    digest.add(a.status);
    digest.add(b.status);
    digest.add(check_stream(memory_source(two.first, two.count), index_a, 1).status);
    const std::uint64_t size = subtree_index_size(a.source.size / 2 - 26);
    for (std::uint64_t i = 0; i < size; ++i) digest.add_byte(index_a[i]);
    add_answers(digest, a.source);
    const auto combined = [&two](const Source& first, const Source& second) {
        Digest results;
        const Sink sink = {take_digest, &results};
        for (int op = 0; op < 4; ++op) {
            add(results, combine(two.job, static_cast<Operator>(op), first, second, sink));
        }
        add(results, complement(two.job, first, sink));
        return results.value();
    };
    const std::uint64_t expected =
        combined(memory_source(two.first, two.count), memory_source(bytes.kept, bytes.count));
    digest.add(std::uint64_t{combined(a.source, b.source) == expected});
    digest.add(expected);
    return digest.value();
}

} // namespace osem::cross
