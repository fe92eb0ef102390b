// Vectors of the picture's geometry. The root octant is the unit cube there.
#ifndef OSEM_HOST_VECTOR_HPP
#define OSEM_HOST_VECTOR_HPP

#include <array>
#include <cmath>

namespace osem::host {

using Vector = std::array<double, 3>;

inline Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector operator*(double s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector normalized(const Vector& a) { return (1 / std::sqrt(dot(a, a))) * a; }

} // namespace osem::host

#endif
