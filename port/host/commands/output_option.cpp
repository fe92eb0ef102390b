#include "commands/output_option.hpp"

#include <filesystem>
#include <system_error>

#include "mesh/text_scanner.hpp"

namespace osem::host {

namespace fs = std::filesystem;

namespace {

// Elsewhere a dash is the standard output; here it would be a file that nobody asked for.
std::string no_name_fault(const std::string& name) {
    if (name == "-") return "expected the name of a file; that of the standard output is /dev/stdout";
    return name.empty() ? "the name of the file to write is empty" : std::string();
}

std::string tree_name_fault(const std::string& name) {
    const std::string extension = fs::path(name).extension().string();
    for (const char* other : {".off", ".obj", ".stl", ".poly", ".png"}) {
        if (equal_ignoring_case(extension, other)) {
            return "an octree is written: expected a name that does not end in " + extension;
        }
    }
    return {};
}

// A file that is still to be written has no identity but its path.
bool same_file(const std::string& a, const std::string& b) {
    std::error_code error;
    if (fs::exists(a, error) && fs::exists(b, error)) return fs::equivalent(a, b, error);
    const fs::path path_a = fs::weakly_canonical(fs::absolute(a, error), error);
    const fs::path path_b = fs::weakly_canonical(fs::absolute(b, error), error);
    return !path_a.empty() && path_a == path_b;
}

} // namespace

CLI::Option* add_output(CLI::App& command, const std::string& name, std::string& target,
                        const std::string& help) {
    return command.add_option(name, target, help)->check(no_name_fault);
}

CLI::Option* add_tree_output(CLI::App& command, const std::string& name, std::string& target,
                             const std::string& help) {
    return add_output(command, name, target, help)->check(tree_name_fault);
}

std::string picture_name_fault(const std::string& name) {
    const fs::path path(name);
    std::error_code error;
    if (equal_ignoring_case(path.extension().string(), ".png") || fs::is_other(path, error)) return {};
    return "pictures are PNG files: expected a name that ends in .png, not " + name;
}

CLI::Option* add_picture_output(CLI::App& command, const std::string& name, std::string& target,
                                const std::string& help) {
    return add_output(command, name, target, help)->check(picture_name_fault);
}

void refuse_same_file(const char* option, const std::string& output, const std::string& what,
                      const std::string& other) {
    if (same_file(output, other)) {
        throw CLI::ValidationError(option, "the same file as " + what + ' ' + other);
    }
}

} // namespace osem::host
