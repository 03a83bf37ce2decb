(** The links of the documents: where they lead. *)

val faults : string -> string list
(** [faults path]: each link of a Markdown document that leads nowhere, with its line: a relative path that is
    no file, an anchor that no heading of its document has, a path of this project between backquotes
    ([`lib/foundation/base/codes.txt`]) that is not there. Addresses of the web are not followed; what stands in a
    block of code is no link. *)
