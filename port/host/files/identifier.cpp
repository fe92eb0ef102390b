#include "files/identifier.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace osem::host {

namespace {

// Sorted.
constexpr const char* taken[] = {"alignas",
                                 "alignof",
                                 "and",
                                 "and_eq",
                                 "asm",
                                 "auto",
                                 "bitand",
                                 "bitor",
                                 "bool",
                                 "break",
                                 "case",
                                 "catch",
                                 "char",
                                 "char16_t",
                                 "char32_t",
                                 "char8_t",
                                 "class",
                                 "co_await",
                                 "co_return",
                                 "co_yield",
                                 "compl",
                                 "concept",
                                 "const",
                                 "const_cast",
                                 "consteval",
                                 "constexpr",
                                 "constinit",
                                 "continue",
                                 "decltype",
                                 "default",
                                 "delete",
                                 "do",
                                 "double",
                                 "dynamic_cast",
                                 "else",
                                 "enum",
                                 "explicit",
                                 "export",
                                 "extern",
                                 "false",
                                 "float",
                                 "for",
                                 "friend",
                                 "goto",
                                 "if",
                                 "inline",
                                 "int",
                                 "long",
                                 "main",
                                 "mutable",
                                 "namespace",
                                 "new",
                                 "noexcept",
                                 "not",
                                 "not_eq",
                                 "nullptr",
                                 "operator",
                                 "or",
                                 "or_eq",
                                 "osem",
                                 "private",
                                 "protected",
                                 "public",
                                 "register",
                                 "reinterpret_cast",
                                 "requires",
                                 "return",
                                 "short",
                                 "signed",
                                 "sizeof",
                                 "static",
                                 "static_assert",
                                 "static_cast",
                                 "std",
                                 "struct",
                                 "switch",
                                 "template",
                                 "this",
                                 "thread_local",
                                 "throw",
                                 "true",
                                 "try",
                                 "typedef",
                                 "typeid",
                                 "typename",
                                 "union",
                                 "unsigned",
                                 "using",
                                 "virtual",
                                 "void",
                                 "volatile",
                                 "wchar_t",
                                 "while",
                                 "xor",
                                 "xor_eq"};

// The C library's notions of letters depend on the locale.
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool may_stand_in_name(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

} // namespace

std::string identifier_fault(const std::string& name) {
    const bool spelt_well = !name.empty() && is_letter(name[0]) &&
                            std::all_of(name.begin(), name.end(), may_stand_in_name) &&
                            name.find("__") == std::string::npos;
    if (!spelt_well) {
        return "expected a name of letters, digits and single underscores that begins with a letter";
    }
    if (std::binary_search(std::begin(taken), std::end(taken), name)) return "the name " + name + " is taken";
    return {};
}

std::string identifier_of(const std::string& path) {
    std::string name;
    for (const char c : std::filesystem::path(path).stem().string()) {
        const char fitting = may_stand_in_name(c) ? c : '_';
        const bool repeated = fitting == '_' && (name.empty() || name.back() == '_');
        if (!repeated) name += fitting;
    }
    return identifier_fault(name).empty() ? name : "shape_" + name;
}

} // namespace osem::host
