(** Comments and empty lines: what a text contains besides its tokens. The printer puts them back. *)

type kind =
  | Blank  (** one or more empty lines *)
  | Line  (** [// …], without its line end *)
  | Block  (** [/* … */] *)

type t = {
  kind : kind;
  text : string;  (** as written, line ends as ["\n"]; empty for [Blank] *)
  start : int;  (** offset of the first byte *)
  stop : int;  (** offset after the last byte *)
  own_line : bool;  (** nothing but spaces stands before it on its line *)
}

val is_comment : t -> bool
(** [is_comment t] is true for comments and false for empty lines. *)
