(** Parts of a ZIP file (APPNOTE of PKWARE) that is a text in memory. *)

open Scc_base

type t

val read : path:string -> string -> (t, Diag.t) result
(** The archive, by the directory at its end. Refused (SC0320): ZIP64 directories, archives of several files,
    and lengths that contradict the text. *)

val find : t -> string -> (string option, Diag.t) result
(** The contents of a part, by its name without a leading slash; the case of letters is ignored. [None] if
    there is no such part. A part is stored or deflated. Refused (SC0320): a name that occurs twice,
    encryption, other methods, and contents of another length or checksum than in the directory. Contents of
    more than a mebibyte and 100 times their size in the file, or of more than 512 mebibytes, are refused
    before they are inflated. *)
