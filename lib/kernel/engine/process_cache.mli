(** A cache of the answers about single processes and pairs of processes. One step of a network changes few
    processes, and the answers about the others stay valid.

    For each leaf, the cache has the 6 processes that begin with this leaf and were used last. It compares
    processes by physical equality: a process that is built again is another one. *)

val create : unit -> Scc_semantics.Memo.t
(** An empty cache. *)
