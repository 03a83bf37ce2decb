(** The formats of scc that are said as {!Scc_json.Json_format}. *)

open Scc_json

(** A format, whatever its values. If it reads what it writes, up to a function, that function makes a value to
    write of a value that was read. *)
type format = Format : ('w, 'r) Json_format.t * ('r -> 'w) option -> format

type file = { schema : Json_schema.file; format : format option  (** of whole documents *) }

val all : file list
(** The files of [specs/schema] that follow from formats. *)
