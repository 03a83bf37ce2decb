(** The functions of [Stdlib.List] that, in some version of OCaml, take stack for each element, in constant stack.

    The libraries of scc are compiled with this module open ([lib/dune]): there [List.map] and [@] are those
    of this module, and lists may be as long as memory allows. Results, the order of calls, and errors are those of
    the standard library. *)

module List : sig
  include module type of Stdlib.List

  val init : int -> (int -> 'a) -> 'a list
  (** [init n f] is the list of [f 0] to [f (n - 1)], called in this order. [Invalid_argument] if [n < 0]. *)

  val map : ('a -> 'b) -> 'a list -> 'b list
  (** [map f list] is the list of the results of [f], called from the first element to the last. *)

  val mapi : (int -> 'a -> 'b) -> 'a list -> 'b list
  (** [mapi f list] is as {!map}; [f] gets the index of the element, from 0, as its first argument. *)

  val map2 : ('a -> 'b -> 'c) -> 'a list -> 'b list -> 'c list
  (** [map2 f a b] is the list of [f x y] for the elements at equal places, called in order. [Invalid_argument] if
      the lengths differ, after the calls for the shorter list. *)

  val append : 'a list -> 'a list -> 'a list
  (** [append a b] is the elements of [a], then those of [b]; [b] is shared and not copied. *)

  val concat : 'a list list -> 'a list
  (** [concat lists] is all elements of all lists, in order. *)

  val flatten : 'a list list -> 'a list
  (** [flatten] is {!concat}. *)

  val fold_right : ('a -> 'b -> 'b) -> 'a list -> 'b -> 'b
  (** [fold_right f [a; b; c] last] is [f a (f b (f c last))]. *)

  val fold_right2 : ('a -> 'b -> 'c -> 'c) -> 'a list -> 'b list -> 'c -> 'c
  (** [fold_right2 f [a; b] [x; y] last] is [f a x (f b y last)]. [Invalid_argument] if the lengths differ, before
      any call. *)

  val split : ('a * 'b) list -> 'a list * 'b list
  (** [split pairs] is the list of the first components and the list of the second ones. *)

  val combine : 'a list -> 'b list -> ('a * 'b) list
  (** [combine a b] is the list of the pairs at equal places. [Invalid_argument] if the lengths differ. *)

  val merge : ('a -> 'a -> int) -> 'a list -> 'a list -> 'a list
  (** [merge compare a b] is the sorted list of the elements of two sorted lists. Of two equal elements, that of
      [a] comes first. *)

  val remove_assoc : 'a -> ('a * 'b) list -> ('a * 'b) list
  (** [remove_assoc key list] is the list without the first pair whose key is structurally equal to [key]. *)

  val remove_assq : 'a -> ('a * 'b) list -> ('a * 'b) list
  (** [remove_assq key list] is the list without the first pair whose key is physically equal to [key]. *)
end

val ( @ ) : 'a list -> 'a list -> 'a list
(** [a @ b] is [List.append a b]. *)
