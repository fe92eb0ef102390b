// Replays vector files: osem_replay FILE... Exit code 0 when every case is right, 1 when one is not, 2 when a
// file cannot be read.
#include "arena.hpp"
#include "platform.hpp"
#include "reader.hpp"
#include "report.hpp"
#include "topics.hpp"

// Bytes of all the memory that cases are given; what does not fit is counted as too large.
#ifndef OSEM_REPLAY_ARENA
#define OSEM_REPLAY_ARENA (64 * 1024 * 1024)
#endif

namespace {

using namespace osem::cross;
using osem::port::print;
using osem::port::print_number;

alignas(8) std::uint8_t memory[OSEM_REPLAY_ARENA];
Reader reader; // static, because it is too large for a small stack

using Replay = bool (*)(Reader&, Arena&, Report&);
constexpr Replay replays[topic_count] = {
    replay_orientation, replay_plane,   replay_classify, replay_crossing, replay_frame,
    replay_conversion,  replay_boolean, replay_measure,  replay_query,    replay_csg,
    replay_transform,   replay_slice,   replay_stream,   replay_surface,  replay_fit};

// A file is read through once before it is replayed, so that the cases of a damaged one are not run.
bool is_whole(const char* path) {
    if (!reader.open(path)) return false;
    while (reader.next_record()) reader.skip_record();
    return reader.fault() == nullptr;
}

void replay_record(Replay replay, Report& report) {
    Arena arena(memory, sizeof memory);
    if (replay(reader, arena, report)) return;
    report.too_large(reader.cases());
    reader.skip_record();
}

void print_line(const char* name, const Totals& totals) {
    print(name);
    print(" cases=");
    print_number(totals.cases);
    print(" failures=");
    print_number(totals.failures);
    print(" too_large=");
    print_number(totals.too_large);
    print("\n");
}

// False when the file cannot be read.
bool replay_file(const char* path, Totals& sum) {
    if (is_whole(path) && reader.open(path)) {
        const auto topic = static_cast<unsigned>(reader.topic());
        Report report(path);
        while (reader.next_record()) replay_record(replays[topic], report);
        const Totals& totals = report.totals();
        print_line(topic_names[topic], totals);
        sum.cases += totals.cases;
        sum.failures += totals.failures;
        sum.too_large += totals.too_large;
    }
    if (reader.fault() == nullptr) return true;
    print(path);
    print(": ");
    print(reader.fault());
    print("\n");
    return false;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        print("usage: osem_replay FILE...\n");
        return 2;
    }
    Totals sum;
    for (int i = 1; i < argc; ++i) {
        if (!replay_file(argv[i], sum)) return 2;
    }
    print_line("replay", sum);
    return sum.failures == 0 ? 0 : 1;
}
