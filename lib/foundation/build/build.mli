(** What this program was built from. *)

val digest : string
(** Of the sources and of the versions of the compiler and the libraries whose arithmetic and storage it uses, in
    hexadecimal digits: two programs with the same one do the same. It is made when the program is built, as
    reading a program of 30 MB takes longer than many an exploration. *)
