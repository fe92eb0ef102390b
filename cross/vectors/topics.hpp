// One function a topic: makes its vectors and writes them into the folder.
#ifndef OSEM_VECTORS_TOPICS_HPP
#define OSEM_VECTORS_TOPICS_HPP

#include <string>

namespace vectors {

void write_orientation(const std::string& folder);
void write_plane(const std::string& folder);
void write_classify(const std::string& folder);
void write_crossing(const std::string& folder);
void write_frame(const std::string& folder);
void write_conversion(const std::string& folder);
void write_boolean(const std::string& folder);
void write_measure(const std::string& folder);
void write_query(const std::string& folder);
void write_csg(const std::string& folder);
void write_transform(const std::string& folder);
void write_slice(const std::string& folder);
void write_stream(const std::string& folder);
void write_surface(const std::string& folder);
void write_fit(const std::string& folder);

} // namespace vectors

#endif
