(** A cache of what single processes and pairs of processes do. One step of a network changes few processes, and
    what the others do by themselves stays as it was.

    The cache keeps a few processes for each leaf, the last ones that were asked about. It compares processes by
    their address in memory: a process that is built anew is another one. *)

val create : unit -> Scc_semantics.Memo.t
(** An empty cache. *)
