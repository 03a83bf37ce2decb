(** Affine maps whose translation may depend on parameters with known ranges. *)

open Scc_exact

type t = { linear : Mat.t; translation : Form.place }

val identity : t
(** The identity map. *)

val translate : Form.place -> t
(** The translation by a vector. *)

val of_linear : Mat.t -> t
(** A linear map, without translation. *)

val compose : t -> t -> t
(** [compose f g] applies [g] first. *)
