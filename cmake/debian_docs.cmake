# Run by cpack on the files to be packaged: Debian has manual pages and the changelog compressed, without
# a time stamp.
file(GLOB_RECURSE _docs ${CPACK_TEMPORARY_DIRECTORY}/*/share/man/*.1 ${CPACK_TEMPORARY_DIRECTORY}/*/changelog)
execute_process(COMMAND gzip -9 -n ${_docs} COMMAND_ERROR_IS_FATAL ANY)
