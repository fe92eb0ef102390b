// One vector file in the making; its format is in cross/replay/format.hpp.
#ifndef OSEM_VECTORS_VECTOR_FILE_HPP
#define OSEM_VECTORS_VECTOR_FILE_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "bytes.hpp"
#include "format.hpp"

namespace vectors {

/// Cases, and how many of them are degenerate (something touches, coincides or is aligned where it need not
/// be) or extreme (a coordinate at or beside an end of its range).
struct Tally {
    std::uint32_t cases = 0;
    std::uint32_t degenerate = 0;
    std::uint32_t extreme = 0;

    void count(bool is_degenerate, bool is_extreme) {
        ++cases;
        degenerate += is_degenerate ? 1U : 0U;
        extreme += is_extreme ? 1U : 0U;
    }
};

class VectorFile {
  public:
    explicit VectorFile(osem::cross::Topic topic) : topic_(topic) {}

    /// Adds a record of as many cases as have been counted since the last one.
    void add_record(Bytes body);

    Tally& tally() { return tally_; }

    /// Puts records with little in them first: those are what the smallest targets have memory for.
    void sort_by_size();

    /// Writes FOLDER/TOPIC.vec and prints a row of the table; throws when it cannot.
    void write(const std::string& folder) const;

    static void print_table_head();

  private:
    struct Record {
        Bytes body;
        std::uint32_t cases;
    };

    osem::cross::Topic topic_;
    std::vector<Record> records_;
    Tally tally_;
    std::uint32_t cases_recorded_ = 0;
};

} // namespace vectors

#endif
