(** Drawings of states for papers, in SVG: what is in front hides what is behind, decided exactly ({!Hidden}). Seen
    from very far, without perspective, so that equal lengths of one direction are equal everywhere. Bodies of one
    family (shape or compound of the model) have one colour; fixed ones are grey. The same state gives the same
    bytes. *)

open Scc_exact
open Scc_calculus

type options = {
  from : Vec.t;  (** the picture is seen from the side to which it points; not zero *)
  up : Vec.t;  (** upwards in the picture, unless that is where it is seen from *)
  width : int;  (** in pixels, within {!Sheet.width_limits} *)
  names : bool;  (** of bodies, where there is room *)
  marks : bool;  (** open features and bonds *)
  key : bool;  (** what the colours and marks mean *)
  bar : bool;  (** a scale *)
  title : string option;
  without : string list;
  (** what is left out, with its marks: bodies, parts of them ([room.south]), and families of bodies *)
}

val default : options
(** As the page of [scc view] shows bodies when it opens: from the front, the right and above, with y upwards; 800
    pixels wide, with marks, key and scale. *)

val unknown : Model.t -> string list -> string option
(** The first name, if any, that means nothing of the model that could be left out. *)

val svg : Model.t -> State.t -> options -> string
