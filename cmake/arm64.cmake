# Toolchain for arm64 on a Debian of another architecture: Debian's cross compiler, arm64 libraries beside those of this
# machine, and qemu, which runs the tests. cmake/arm64.sh sets all of it up.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_C_COMPILER ${CMAKE_LIBRARY_ARCHITECTURE}-gcc)
set(CMAKE_CXX_COMPILER ${CMAKE_LIBRARY_ARCHITECTURE}-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static)
set(ENV{PKG_CONFIG_LIBDIR} /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/pkgconfig:/usr/share/pkgconfig)

# Of Qt, moc, rcc and lrelease run on this machine.
execute_process(COMMAND dpkg-architecture -q DEB_BUILD_MULTIARCH
  OUTPUT_VARIABLE _build OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
set(QT_HOST_PATH /usr)
set(QT_HOST_PATH_CMAKE_DIR /usr/lib/${_build}/cmake)

set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE arm64)
