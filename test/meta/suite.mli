(** The conformance suite, specs/conformance: its manifest, and what its files hold. *)

type case = {
  id : string;
  rules : string list;
  obtained : string;  (** how what is expected was obtained *)
}

type file = {
  path : string;  (** from specs/conformance *)
  count : int;  (** of its cases, as the manifest has it *)
  cases : case list;
}

type t = {
  cases : int;  (** in all, as the manifest has it *)
  files : file list;
  rules : (string * (int * string list)) list;  (** how many cases each rule has, and in which files *)
  diagnostics : (string * (string list * string list)) list;
  (** for each code the cases that expect it, and the inputs of command lines *)
}

val read : unit -> t
(** Raises [Yojson] exceptions when a file is not what its schema says. *)
