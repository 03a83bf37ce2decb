(** Reading files and models. *)

open Scc_base
open Scc_exact

val max_bytes : int
(** Files larger than this (64 MiB) are refused. *)

val read : ?max_bytes:int -> string -> (Source.t, Diag.t) result
(** The bytes of a file; ["-"] is standard input. SC0101 when it cannot be read. Not more than {!max_bytes},
    unless told otherwise. *)

val mesh_reader : Console.t -> string -> string -> (string, string) result
(** [mesh_reader c model path] reads a mesh file that a model names, relative to the model's place. *)

(** A model with all that was read for it. *)
type model = {
  elaborated : Scc_elaborate.Elaborate.t;
  source : Source.t;
  digest : string;  (** see {!Scc_exchange.Model_digest} *)
}

val model : Console.t -> overrides:(string * Rat.t) list -> string -> (model, Diag.t list) result
(** Reads, parses and elaborates the file. Its texts become known to the console. *)
