(** How pictures in SVG are drawn: the options that commands share. *)

open Scc_exact

(** What was asked for. *)
type t = { from : Vec.t option; up : Vec.t option; width : int option }

val given : t -> bool
(** Something was asked for. *)

val term : t Cmdliner.Term.t

val of_state : t -> names:bool -> without:string list -> Scc_picture.Picture.options
val of_solid : t -> Scc_picture.Solid_picture.options
