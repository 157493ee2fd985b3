# Every dependency, each from a Debian package (scripts/packages.txt).
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(glm REQUIRED CONFIG)
find_package(Boost REQUIRED) # headers: exact integers of any size
find_package(Imath REQUIRED CONFIG) # the header of half precision
find_package(RapidJSON REQUIRED CONFIG)
find_package(PNG REQUIRED)
find_package(JPEG REQUIRED) # libjpeg-turbo
find_package(PkgConfig REQUIRED)
find_package(ZLIB REQUIRED) # what OpenEXR unpacks, counted before
pkg_check_modules(OpenEXR REQUIRED IMPORTED_TARGET OpenEXR)
pkg_check_modules(Nettle REQUIRED IMPORTED_TARGET nettle>=3.4) # sha256 and base64; loaded in a tenth of libcrypto's time
pkg_check_modules(CMinpack REQUIRED IMPORTED_TARGET cminpack) # least squares of `brdf fit`
find_path(STB_INCLUDE_DIR stb_image.h PATH_SUFFIXES stb REQUIRED)
find_package(CLI11 REQUIRED CONFIG)
