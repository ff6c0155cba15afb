# The libraries of the module: their headers, from a folder that .ci/wasm fills with Debian 12's packages, and Zstandard's
# unpacking from its source. One Debian's, so that the module has the same bytes wherever it is built.
set(libraries ${CMAKE_SOURCE_DIR}/build/wasm-root)
foreach(name glm::glm nlohmann_json::nlohmann_json tl::expected Threads::Threads)
  add_library(${name} INTERFACE IMPORTED)  # the sysroot of the preset has them; there are no threads
endforeach()
add_library(fmt::fmt INTERFACE IMPORTED)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY "FMT_STATIC_THOUSANDS_SEPARATOR=','")
add_library(PkgConfig::xxhash INTERFACE IMPORTED)
target_compile_definitions(PkgConfig::xxhash INTERFACE XXH_INLINE_ALL)

enable_language(C)
file(GLOB zstd ${libraries}/src/libzstd-*/lib)
set(sources common/debug common/entropy_common common/error_private common/fse_decompress common/zstd_common common/xxhash
            decompress/huf_decompress decompress/zstd_ddict decompress/zstd_decompress decompress/zstd_decompress_block)
list(TRANSFORM sources PREPEND ${zstd}/)
list(TRANSFORM sources APPEND .c)
add_library(couloir_zstd OBJECT ${sources})
target_compile_options(couloir_zstd PRIVATE -Os)
target_compile_definitions(couloir_zstd PRIVATE ZSTD_DISABLE_ASM ZSTD_LEGACY_SUPPORT=0 ZSTD_STRIP_ERROR_STRINGS
                           HUF_FORCE_DECOMPRESS_X1 ZSTD_FORCE_DECOMPRESS_SEQUENCES_SHORT)
target_include_directories(couloir_zstd PUBLIC ${zstd})
add_library(PkgConfig::zstd INTERFACE IMPORTED)
target_include_directories(PkgConfig::zstd INTERFACE ${zstd})
