(** The sources from which this program was built. *)

val digest : string
(** The digest, in hexadecimal digits, of the sources, the version of the compiler, and the versions of the
    libraries for arithmetic and storage. Two programs with equal digests behave alike. It is computed at build
    time, as reading a program of 30 MB takes longer than many an exploration. *)
