(** What of the standard library takes stack for each element of a list, in some version of OCaml, in constant
    stack. The libraries of scc are compiled with this module open ([lib/dune]): there [List.map] and [@] are those
    of here, and lists may be as long as memory allows. Results, the order of calls, and errors are those of the
    standard library. *)

module List : sig
  include module type of Stdlib.List

  val init : int -> (int -> 'a) -> 'a list
  val map : ('a -> 'b) -> 'a list -> 'b list
  val mapi : (int -> 'a -> 'b) -> 'a list -> 'b list
  val map2 : ('a -> 'b -> 'c) -> 'a list -> 'b list -> 'c list
  val append : 'a list -> 'a list -> 'a list
  val concat : 'a list list -> 'a list
  val flatten : 'a list list -> 'a list
  val fold_right : ('a -> 'b -> 'b) -> 'a list -> 'b -> 'b
  val fold_right2 : ('a -> 'b -> 'c -> 'c) -> 'a list -> 'b list -> 'c -> 'c
  val split : ('a * 'b) list -> 'a list * 'b list
  val combine : 'a list -> 'b list -> ('a * 'b) list
  val merge : ('a -> 'a -> int) -> 'a list -> 'a list -> 'a list
  val remove_assoc : 'a -> ('a * 'b) list -> ('a * 'b) list
  val remove_assq : 'a -> ('a * 'b) list -> ('a * 'b) list
end

val ( @ ) : 'a list -> 'a list -> 'a list
