# The last touches to the files of the Debian package, as Debian's policy has them.
set(root ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr)

# The system's own folder of libraries needs no search path.
file(RPATH_REMOVE FILE ${root}/bin/murk)
file(GLOB pages ${root}/share/man/man*/*.[15])
execute_process(COMMAND gzip -9 --no-name --force ${pages} ${root}/share/doc/murk/changelog
                COMMAND_ERROR_IS_FATAL ANY)
