// Writes the vector files of cross/replay/format.hpp: osem_vectors OUT_FOLDER. Two runs write the same bytes.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "topics.hpp"
#include "vector_file.hpp"

namespace {

using Write = void (*)(const std::string&);

void write_all(const std::string& folder) {
    struct Entry {
        const char* name;
        Write write;
    };
    constexpr Entry entries[] = {
        {"orientation", vectors::write_orientation},
        {"plane", vectors::write_plane},
        {"classify", vectors::write_classify},
        {"crossing", vectors::write_crossing},
        {"frame", vectors::write_frame},
        {"conversion", vectors::write_conversion},
        {"boolean", vectors::write_boolean},
        {"measure", vectors::write_measure},
        {"query", vectors::write_query},
        {"csg", vectors::write_csg},
        {"transform", vectors::write_transform},
        {"slice", vectors::write_slice},
        {"stream", vectors::write_stream},
        {"surface", vectors::write_surface},
        {"fit", vectors::write_fit},
    };
    std::filesystem::create_directories(folder);
    vectors::VectorFile::print_table_head();
    for (const Entry& entry : entries) {
        std::fprintf(stderr, "%s\n", entry.name);
        entry.write(folder);
        std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: osem_vectors OUT_FOLDER\n");
        return 1;
    }
    try {
        write_all(argv[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "osem_vectors: %s\n", error.what());
        return 1;
    }
    return 0;
}
