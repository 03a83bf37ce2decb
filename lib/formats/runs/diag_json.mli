(** Diagnostics as JSON (see [specs/schema/diagnostics.schema.json]). *)

open Scc_base
open Scc_json

(** A function from the name of a file to its text, for lines and columns. *)
type source = string -> Source.t option

val brief : (Diag.t, unit) Json_format.t
(** The format of a diagnostic by its code and its message alone. *)

val format : (source * Diag.t, unit) Json_format.t
(** The format of a diagnostic. Places are offsets in bytes. Where the text of the file is known, they also have
    line and column from 1; columns count code points. *)

val formats : (source * Diag.t list, unit) Json_format.t
(** The format of an array of diagnostics. *)

val document_format : (int * string option * (source * Diag.t list), unit) Json_format.t
(** The format of {!document}: the exit code, why the work was stopped if it was, and the diagnostics. *)

val diagnostic : source:source -> Diag.t -> Json.t
(** A diagnostic in {!format}. *)

val document : ?stopped:string -> source:source -> exit:int -> Diag.t list -> Json.t
(** The document that a command prints instead of its report if it cannot make one; [stopped] tells why the work
    ended before. *)
