// Options that name a file to write.
#ifndef OSEM_HOST_OUTPUT_OPTION_HPP
#define OSEM_HOST_OUTPUT_OPTION_HPP

#include <string>

#include <CLI/CLI.hpp>

namespace osem::host {

/// Adds an option for the name of a file to write; an empty name is wrong usage.
CLI::Option* add_output(CLI::App& command, const std::string& name, std::string& target,
                        const std::string& help);

/// As add_output, for an octree file: a name that ends as those of meshes and pictures do is wrong usage.
CLI::Option* add_tree_output(CLI::App& command, const std::string& name, std::string& target,
                             const std::string& help);

/// As add_output, for a picture, which is a PNG file.
CLI::Option* add_picture_output(CLI::App& command, const std::string& name, std::string& target,
                                const std::string& help);

/// What is wrong with a picture's file name: a name that does not end in .png, unless it is that of a device
/// or a pipe; else empty.
std::string picture_name_fault(const std::string& name);

/// Throws, as wrong usage of `option`, when its value `output` is the same file as `other`, whatever the two
/// are spelt like; `what` says what the other file is.
void refuse_same_file(const char* option, const std::string& output, const std::string& what,
                      const std::string& other);

} // namespace osem::host

#endif
