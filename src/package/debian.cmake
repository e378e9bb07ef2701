# The last touches to the files of the Debian package, as Debian's policy has them.
set(root ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr)

# The system's own folders need no search paths.
file(RPATH_REMOVE FILE ${root}/bin/murk)
file(GLOB configuration ${root}/lib/*/pkgconfig/murk.pc)
file(READ ${configuration} text)
string(REGEX REPLACE "^prefix=[^\n]*" "prefix=/usr" text "${text}")
file(WRITE ${configuration} "${text}")

configure_file(${CPACK_MURK_CHANGELOG} ${root}/share/doc/murk/changelog COPYONLY)
file(GLOB pages ${root}/share/man/man*/*.[15])
execute_process(COMMAND gzip -9 --no-name --force ${pages} ${root}/share/doc/murk/changelog
                COMMAND_ERROR_IS_FATAL ANY)
