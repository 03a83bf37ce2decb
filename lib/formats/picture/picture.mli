(** Drawings of states for papers, in SVG. What is in front hides what is behind, decided exactly ({!Hidden}).
    There is no perspective, so equal lengths in one direction are equal everywhere, unless a page had it.
    Bodies of one family (shape or compound of the model) have one colour; fixed ones are grey, and of glass
    where they would hide a body entirely ({!Glass}). The same state gives the same bytes. *)

open Scc_exact
open Scc_calculus

(** The viewpoint, and the parts of the drawing. *)
type options = {
  from : Vec.t;  (** the picture is seen from the side to which it points; not zero *)
  up : Vec.t;  (** upwards in the picture, unless that is where it is seen from *)
  width : int;  (** in pixels, within {!Sheet.width_limits} *)
  names : bool;  (** of bodies, where there is room *)
  marks : bool;  (** open features and bonds *)
  key : bool;  (** the meaning of the colours and marks *)
  bar : bool;  (** a scale *)
  title : string option;
  without : string list;
  (** left out, with their marks: bodies, parts of them ([room.south]), and families of bodies *)
  page : Page_camera.t option;  (** instead of [from] and [up]: the camera and the frame of a page *)
}

val default : options
(** The opening view of the page of [scc view]: from the front, the right and above, with y upwards. The picture
    is 800 pixels wide, with marks, key and scale. *)

val unknown : Model.t -> string list -> string option
(** The first of these names that is no body, part or family of the model. *)

val svg : Model.t -> State.t -> options -> string
(** The drawing of a state as the text of an SVG file. *)
