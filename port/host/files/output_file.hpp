// A file that appears whole or not at all.
#ifndef OSEM_HOST_OUTPUT_FILE_HPP
#define OSEM_HOST_OUTPUT_FILE_HPP

#include <fstream>
#include <ostream>
#include <string>

namespace osem::host {

/// Writes to a new file beside the target and renames it over the target in commit(). Without commit the new
/// file is removed and the target stays as it was. A target that is replaced passes on its permissions, but
/// not to whom it belongs. A process that is killed leaves the new file behind, which is called as the target
/// and .part0, or a higher number. A symbolic link is followed, unless to nothing, which is refused; a target
/// that is no regular file (a device, a pipe) is written directly. Faults are thrown as BadInput that names
/// the target.
class OutputFile {
  public:
    explicit OutputFile(const std::string& target);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Throws unless a file can be created there; leaves nothing behind. Asked before long work, so that the
    /// new file itself stands there only while it is written.
    static void probe(const std::string& target);

    std::ostream& stream() { return stream_; }
    /// Whether what is written can be written over: no device and no pipe.
    bool is_regular() const { return !temporary_.empty(); }

    /// Ends writing and puts the file in its place.
    void commit();

  private:
    void create_beside();

    std::string name_;      ///< as the user gave it
    std::string target_;    ///< where links lead
    std::string temporary_; ///< empty when nothing is to be removed
    std::ofstream stream_;
};

} // namespace osem::host

#endif
