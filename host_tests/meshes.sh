# Sourced: unpack_meshes FOLDER brings the meshes of CGAL's demo package there and prints where they are.
# Minimal images leave documentation folders out when they install, so the package is unpacked by hand.
unpack_meshes() {
    local meshes=$1/cgal-demo
    if [ ! -d "$meshes/data/meshes" ]; then
        rm -rf "$meshes"
        mkdir -p "$meshes"
        (cd "$meshes" && apt-get download -qq libcgal-demo 2> /dev/null && dpkg-deb -x libcgal-demo_*.deb package &&
         tar xzf package/usr/share/doc/libcgal-dev/data.tar.gz && rm -rf package libcgal-demo_*.deb) >&2
    fi
    echo "$meshes/data"
}
