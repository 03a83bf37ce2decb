(** The ranks of the new states of a level: their places in the order in which a single search would find them.
    That is the order of their keys: the rank of the state before, and the place of the transition.

    The ranks of the states before are dealt out to the owners in blocks. Each owner tells each other one the
    keys that fall into the block of that one, is told their ranks within the block and the size of the block,
    and adds the sizes of the blocks before. *)

open Scc_codec

val agree :
  Mesh.t ->
  width:int ->
  length:int ->
  keys:(int -> int * int) ->
  mine:'a ->
  put:(Buffer.t -> 'a -> unit) ->
  read:(Packed.source -> 'a) ->
  'a array * int array
(** [agree mesh ~width ~length ~keys ~mine ~put ~read] is called by all owners: two rounds of messages. [keys k] is
    the rank of the state before, below [width], and the place of the transition, of the [k]-th new state of this
    owner in the order of keys; there are [length]. The result is what each owner tells beside its keys, of which
    [mine] is that of this one, and the ranks of its new states. Raises {!Failure.Failed} for what [read] refuses.
*)
