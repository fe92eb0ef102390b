// Damaged octree files: whatever byte is wrong or missing, the file is refused and nothing is written.
#include "support.hpp"

namespace osem::tool_test {

namespace {

class Damaged : public Tool {
  protected:
    void SetUp() override {
        Tool::SetUp();
        // No border of the box lies on one of the lattice's planes at depth 3, so every level has grey
        // octants.
        make_box("whole", {0.21, 0.32, 0.43}, {0.54, 0.65, 0.76}, {"--depth", "3"});
        bytes_ = read_file(path("whole.osem"));
        ASSERT_GT(bytes_.size(), 100U);
        ASSERT_LT(bytes_.size(), 2000U);
    }

    ::testing::AssertionResult refused(const std::string& bytes, const std::string& part) const {
        write_file(path("bad.osem"), bytes);
        return failed(osem({"info", path("bad.osem")}), 2, part);
    }

    std::string bytes_;
};

TEST_F(Damaged, EveryBitOfEveryByteCounts) {
    for (std::size_t i = 0; i < bytes_.size(); ++i) {
        for (unsigned bit = 0; bit < 8; ++bit) {
            std::string damaged = bytes_;
            damaged[i] = static_cast<char>(static_cast<unsigned char>(damaged[i]) ^ (1U << bit));
            ASSERT_TRUE(refused(damaged, " at byte ")) << "bit " << bit << " of byte " << i;
        }
    }
}

TEST_F(Damaged, EveryTruncationIsSeen) {
    for (std::size_t size = 0; size < bytes_.size(); ++size) {
        ASSERT_TRUE(refused(bytes_.substr(0, size), " at byte ")) << size;
    }
}

TEST_F(Damaged, BytesBehindTheEndAreSeen) {
    EXPECT_TRUE(refused(bytes_ + '\0', "at byte " + std::to_string(bytes_.size())));
    EXPECT_TRUE(refused(bytes_ + bytes_, "at byte " + std::to_string(bytes_.size())));
}

TEST_F(Damaged, TheFileAndThePayloadAreNamed) {
    std::string damaged = bytes_;
    damaged[damaged.size() - 1] = static_cast<char>(damaged[damaged.size() - 1] ^ 1);
    EXPECT_TRUE(refused(damaged, path("bad.osem") + ": "));
    EXPECT_TRUE(refused(damaged, "payload"));
    EXPECT_TRUE(refused(std::string(4096, 'x'), "at byte 0"));
}

TEST_F(Damaged, NoCommandWritesFromADamagedFile) {
    std::string damaged = bytes_;
    damaged[60] = static_cast<char>(damaged[60] ^ 1);
    write_file(path("bad.osem"), damaged);
    const auto before = files();
    const std::string bad = path("bad.osem");
    const std::string good = path("whole.osem");
    const std::string out = path("out.png");
    const std::string tree = path("out.osem");
    using Names = std::vector<std::string>;
    for (const Names& line :
         {Names{"union", good, bad, "-o", tree}, Names{"intersection", bad, good, "-o", tree},
          Names{"difference", good, bad, "-o", tree}, Names{"xor", bad, good, "-o", tree},
          Names{"complement", bad, "-o", tree}, Names{"image", bad, "-o", out},
          Names{"slice", bad, "-o", out, "--axis", "y", "--at", "0.5"}, Names{"leaves", bad},
          Names{"carray", bad, "-o", out}}) {
        const Ran ran = osem(line);
        EXPECT_TRUE(failed(ran, 2, "bad.osem")) << line[0];
        EXPECT_TRUE(ran.out.empty()) << line[0];
    }
    EXPECT_EQ(files(), before);
}

// CRC-32 of IEEE 802.3, bit by bit.
std::uint32_t crc32(const std::string& bytes) {
    std::uint32_t crc = 0xffffffffU;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
    }
    return ~crc;
}

TEST_F(Damaged, ACheckedHeaderMayStillLie) {
    ASSERT_EQ(crc32("123456789"), 0xcbf43926U); // the check value of the polynomial's catalogue entry
    const auto lying = [&](std::size_t at, const std::string& patch) {
        std::string forged = bytes_;
        forged.replace(at, patch.size(), patch);
        const std::uint32_t crc = crc32(forged.substr(0, 44));
        for (unsigned i = 0; i < 4; ++i) forged[44 + i] = static_cast<char>((crc >> (8 * i)) & 0xffU);
        return forged;
    };
    const std::string infinity("\0\0\0\0\0\0\xf0\x7f", 8);
    const std::string nan("\0\0\0\0\0\0\xf8\x7f", 8);
    const std::string minus_one("\0\0\0\0\0\0\xf0\xbf", 8);
    EXPECT_EQ(lying(0, ""), bytes_);
    EXPECT_TRUE(refused(lying(8, nan), "frame"));
    EXPECT_TRUE(refused(lying(24, infinity), "frame"));
    EXPECT_TRUE(refused(lying(32, infinity), "frame"));
    EXPECT_TRUE(refused(lying(32, minus_one), "frame"));
    EXPECT_TRUE(refused(lying(32, std::string(8, '\0')), "frame"));
    EXPECT_TRUE(refused(lying(6, "\x02"), "at byte 6"));
    // Four thousand million nodes are not there, and no memory is asked for them.
    EXPECT_TRUE(refused(lying(40, "\xff\xff\xff\xff"), "at byte " + std::to_string(bytes_.size())));
    // A tree of depth 3 has a grey octant at level 2, which a tree of depth 2 has not.
    EXPECT_TRUE(refused(lying(5, "\x02"), "at byte "));
}

} // namespace

} // namespace osem::tool_test
