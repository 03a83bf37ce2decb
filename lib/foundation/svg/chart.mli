(** Charts of one number over another, as SVG. Coordinates in the picture are rounded. The numbers beside the axes
    are exact, if they have at most twelve places. *)

open Scc_exact

type point = {
  x : Rat.t;
  y : Rat.t;
  band : (Rat.t * Rat.t) option;  (** an interval around y, from the first to the second: drawn pale *)
}

type curve = {
  name : string;  (** shown beside the title, if there are several curves *)
  pieces : point list list;  (** by increasing x; points are joined within a piece only *)
}

type panel = { title : string; curves : curve list }

(** {1 Maps} *)

type amount =
  | Nothing
  | Named of string  (** drawn in the colour of this name *)
  | Amount of Rat.t  (** the darker, the greater it is among the amounts of its map *)

type cell = { said : string;  (** shown while the pointer is over the cell *) amount : amount }

type map = {
  title : string;
  rows : string array;  (** the labels of the rows, from below *)
  columns : string array;
  cells : cell array array;  (** by row and column *)
}

val sheet :
  title:string ->
  caption:string ->
  x:string ->
  named:(string * string) list ->
  panel list ->
  map list ->
  string
(** [sheet ~title ~caption ~x ~named panels maps] is an SVG document. The panels stand one below the other over one
    x axis with the label [x], and the maps below them. [named] is the colour of each name of a {!Named} cell. *)
