# Sourced: unpack_meshes FOLDER brings the meshes of CGAL's demo package there and prints where they are.
# Minimal images leave documentation folders out when they install, so the package is unpacked by hand.
unpack_meshes() {
    local meshes=$1/cgal-demo
    if [ ! -d "$meshes" ]; then
        rm -rf "$meshes.part"
        mkdir -p "$meshes.part"
        (cd "$meshes.part" && apt-get download -qq libcgal-demo && dpkg-deb -x libcgal-demo_*.deb package &&
         tar xzf package/usr/share/doc/libcgal-dev/data.tar.gz && rm -rf package libcgal-demo_*.deb) >&2 || {
            echo "cannot bring the meshes of libcgal-demo" >&2
            return 1
        }
        mv "$meshes.part" "$meshes"
    fi
    echo "$meshes/data"
}
