(** Affine maps whose translation may depend on parameters of which ranges are known. *)

open Scc_exact

type t = { linear : Mat.t; translation : Form.place }

val identity : t
val translate : Form.place -> t
val of_linear : Mat.t -> t

val compose : t -> t -> t
(** The second is applied first. *)

val fixed : t -> Affine.t option
(** Where it depends on nothing. *)
