#include "vector_file.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace vectors {

void VectorFile::add_record(Bytes body) {
    const std::uint32_t cases = tally_.cases - cases_recorded_;
    if (cases == 0 || cases > UINT16_MAX) throw std::logic_error("a record of too few or too many cases");
    cases_recorded_ = tally_.cases;
    records_.push_back({std::move(body), cases});
}

void VectorFile::sort_by_size() {
    std::stable_sort(records_.begin(), records_.end(), [](const Record& a, const Record& b) {
        return a.body.data().size() < b.body.data().size();
    });
}

void VectorFile::write(const std::string& folder) const {
    using namespace osem::cross;
    Bytes file;
    for (const std::uint8_t letter : magic) file.u8(letter);
    file.u8(format_version);
    file.u8(static_cast<std::uint64_t>(topic_));
    file.u16(0);
    file.u32(tally_.cases);
    for (const Record& record : records_) {
        file.u32(record.body.data().size());
        file.u16(record.cases);
        file.append(record.body);
    }
    file.u32(end_marker);
    file.u32(crc_32(file.data()));

    const char* name = topic_names[static_cast<unsigned>(topic_)];
    const std::string path = folder + "/" + name + ".vec";
    std::ofstream out(path, std::ios::binary);
    out.write(reinterpret_cast<const char*>(file.data().data()),
              static_cast<std::streamsize>(file.data().size()));
    out.close();
    if (!out) throw std::runtime_error("cannot write " + path);
    std::printf("%-12s %8u %8u %11u %8u %10zu\n", name, static_cast<unsigned>(records_.size()), tally_.cases,
                tally_.degenerate, tally_.extreme, file.data().size());
}

void VectorFile::print_table_head() {
    std::printf("%-12s %8s %8s %11s %8s %10s\n", "topic", "records", "cases", "degenerate", "extreme",
                "bytes");
}

} // namespace vectors
