(** Parts of a ZIP file (PKWARE's APPNOTE) that is a text in memory. *)

open Scc_base

type t

val read : path:string -> string -> (t, Diag.t) result
(** The directory at its end. Refused (SC0320): ZIP64 directories, archives of several files, and what lies about
    its length. *)

val find : t -> string -> (string option, Diag.t) result
(** The contents of a part, by its name without a slash at the front; letters count in either case. A part is
    stored or deflated. Refused (SC0320): a name that there is twice, encryption, other methods, contents of
    another length or checksum than the directory says; and, before anything is inflated, contents of more than a
    mebibyte and 100 times what they take in the file, or more than 512 mebibytes. *)
