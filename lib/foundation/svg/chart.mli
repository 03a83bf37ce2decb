(** Charts of numbers over a number, as SVG. What is drawn is rounded; numbers beside the axes are exact. *)

open Scc_exact

type point = {
  x : Rat.t;
  y : Rat.t;
  band : (Rat.t * Rat.t) option;  (** from the first to the second, around y: drawn pale *)
}

type curve = {
  name : string;  (** said beside it, if there are several *)
  pieces : point list list;  (** joined within a piece, by increasing x; not from one to the next *)
}

type panel = { title : string; curves : curve list }

val ticks : least:Rat.t -> greatest:Rat.t -> about:int -> Rat.t list
(** Multiples of 1, 2 or 5 times a power of ten from the one number to the other, at most so many and two more. Of
    a range that is empty the number itself. *)

(** {1 Maps} *)

type amount =
  | Nothing
  | Named of string  (** with a colour of its own *)
  | Amount of Rat.t  (** darker, the greater among those of its map *)

type cell = { said : string;  (** while the pointer is over it *) amount : amount }

type map = {
  title : string;
  rows : string array;  (** what is beside each, from below *)
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
(** A document: the panels one below the other over the same x axis, which bears that name, and the maps below
    them. [named] are the colours of names. *)
