(** The lattices of the bodies that diffuse (rule Diffuse), as reports state them. *)

open Scc_base
open Scc_exact

(** Bodies on one lattice. *)
type t = {
  bodies : string list;  (** names of bodies; a family once, by its name *)
  lattice : Diffusion.lattice;
  at : Span.t;  (** a law that gives it *)
}

val of_bodies : (string * Diffusion.lattice * Span.t) list -> t list
(** The lattices of bodies, given by name, each lattice once and in order. *)

val settings : t list -> (string * string) list
(** The entries of reports: [("kick", "1")], and [("kick chosen as", "the least power of two …")] if the model does
    not give it. Where there are several lattices the names of the bodies are there as well. *)

val line : t list -> string option
(** [line lattices] is {!settings} in one line, if there are any. *)

val kicks : t list -> string
(** The lengths of the kicks for one field of a table: ["1"], or ["p 1; c 2"] if they differ. *)

val changed : t list -> from:t list -> (t * Rat.t) option
(** [changed l ~from] is the first lattice of [l] whose kick was chosen and is another than that of the same bodies
    in [from], with that kick. *)
