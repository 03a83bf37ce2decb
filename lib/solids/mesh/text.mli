(** Mesh files as lines of words, each with its place; and numbers in them. *)

open Scc_base
open Scc_exact

type word = { text : string; start : int  (** byte offset in the file *) }

val next_line : ?continued:bool -> string -> int -> (word list * int) option
(** [next_line text position] are the words of the first line at or after [position] that has any, and the
    position after that line. Blanks, tabs and form feeds separate words; [#] starts a comment; LF, CR and CRLF
    end lines. With [continued], a backslash before the line end joins the next line to this one. *)

(** {1 Faults} *)

val error : path:string -> word -> ('a, unit, string, ('b, Diag.t) result) format4 -> 'a
(** An error SC0320, located at the word. *)

val error_at : path:string -> int -> ('a, unit, string, ('b, Diag.t) result) format4 -> 'a
(** An error SC0320, located at a byte offset. *)

val quote : string -> string
(** The text in backquotes, cut to 40 bytes, with escapes for characters that are not printable. *)

(** {1 Numbers} *)

val max_digits : int
(** The greatest number of digits of a coordinate, written out: 1000. It bounds the memory that a small file
    can ask for. *)

val coordinate : path:string -> word -> (Rat.t, Diag.t) result
(** The exact value of a decimal. Beyond [Rat.of_literal], a point may lead or end the digits, as C prints and
    reads them. Fractions [p/q] are read too. *)

val is_number : word -> bool
(** [is_number w] is true for numbers of {!coordinate}, of any length, and for those that are not finite. *)

val coordinates : path:string -> word list -> (Vec.t, Diag.t) result
(** The point given by the first three words, which exist (a bug otherwise). *)

val integer : path:string -> what:string -> word -> (int, Diag.t) result
(** A decimal integer of at most nine digits; [what] names it in the error. *)

val vertex : path:string -> count:int -> word -> (int, Diag.t) result
(** [vertex ~path ~count word] is an index from 0 to [count - 1]. *)

(** {1 Sets of faces} *)

val labelled : Vec.t list -> (string option * int array) list -> Scc_geometry.Polyhedron.ifs
(** A set from vertices and faces, both in reverse order. Vertices are named [v0], …, and faces by
    {!Face_names}. *)

val ifs : Vec.t list -> int array list -> Scc_geometry.Polyhedron.ifs
(** A set from vertices and faces, both in reverse order, named [v0], … and [f0], … *)
