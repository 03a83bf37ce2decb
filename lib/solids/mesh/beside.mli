(** Files that a mesh file names: they are looked up in its own folder, and in folders there. *)

type reader = string -> (string, string) result
(** The contents of a file, by its path as that of the mesh file is given; or why it cannot be read. *)

val none : reader
(** Reads no file. *)

val find : reader -> path:string -> string -> (string, string) result
(** [find read ~path name] is the file of that name beside the file [path]. A name that leads out of its folder (by
    [..], a leading slash, a drive, an address) is refused. *)

val address : reader -> path:string -> string -> (string * string, string) result
(** [address read ~path name] is the path and the contents of the file that {!find} has. If there is none,
    it is the one of the name that [name] writes by {!Scc_base.Percent}, as addresses do. *)
