(** The options for drawings in SVG that commands share. *)

open Scc_exact

(** The options as given. *)
type t = { from : Vec.t option; up : Vec.t option; width : int option }

val given : t -> bool
(** [given t] is true if any of the options is given. *)

val term : t Cmdliner.Term.t
(** The options [--from], [--up] and [--width]. *)

val looks : t -> bool
(** [looks t] is true if [--from] or [--up] is given. *)

val of_state :
  t -> Camera_link.t option -> names:bool -> without:string list -> Scc_picture.Picture.options
(** The options for a drawing of a state, perhaps from the camera of a page; others are those of
    {!Scc_picture.Picture.default}. *)

val of_solid : t -> Scc_picture.Solid_picture.options
(** The options for a drawing of a shape; others are those of {!Scc_picture.Solid_picture.default}. *)
