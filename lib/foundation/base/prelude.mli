(** The names that every file of [lib/] sees without opening a module ([lib/dune]). *)

val ( let* ) : ('a, 'e) result -> ('a -> ('b, 'e) result) -> ('b, 'e) result
(** [let* x = r in e] is [e] with the value of [r] for [x], or the error of [r]. *)

val ( let*? ) : 'a option -> ('a -> 'b option) -> 'b option
(** [let*? x = o in e] is [e] with the value of [o] for [x], or [None] if there is no value. *)

val ( <?> ) : int -> (unit -> int) -> int
(** [c <?> next] is [c], the result of a comparison, or if that is 0, the next comparison. *)

(** [Stdlib.Option] and functions of two options. *)
module Option : sig
  include module type of Stdlib.Option

  val merge : ('a -> 'a -> 'a) -> 'a option -> 'a option -> 'a option
  (** [merge f a b] is [Some (f x y)] for two values, the value if there is one, and otherwise [None]. *)

  val map2 : ('a -> 'b -> 'c) -> 'a option -> 'b option -> 'c option
  (** [map2 f a b] is [Some (f x y)] for two values, and otherwise [None]. *)

  val all : ('a -> 'b option) -> 'a list -> 'b list option
  (** [all f list] is the values of [f] for the elements of [list], in order, or [None] if one of them has none.
      [f] is applied to all of them. *)
end

(** [Stdlib.Result] and functions of lists. *)
module Result : sig
  include module type of Stdlib.Result

  val all : ('a -> ('b, 'e) result) -> 'a list -> ('b list, 'e) result
  (** [all f list] is the values of [f] for the elements of [list], in order, or the first error. Nothing after
      that is looked at. *)

  val listed : ('a, 'e) result -> ('a, 'e list) result
  (** [listed r] is [r] with its error as the only one of a list. *)
end
