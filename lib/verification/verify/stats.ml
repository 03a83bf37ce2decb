open Scc_exact

type t = {
  states : int;
  transitions : int;
  depth : int;
  model_time : Rat.t option;
  complete : bool;
  eventful : bool;
  decided_early : bool;
  split_step : Rat.t option;
  stopped_by : Verdict.truncation list;
  faults : Scc_base.Diag.t list;
  dead_ends : Scc_base.Diag.t list;
  converges : Verdict.convergence option;
  growth : Scc_base.Diag.t option;
  shared : Scc_base.Diag.t option;
  causes : Growth.cause list;
  left_out : Verdict.truncation option;
}

let none =
  {
    states = 0;
    transitions = 0;
    depth = 0;
    model_time = None;
    complete = false;
    eventful = true;
    decided_early = true;
    split_step = None;
    stopped_by = [];
    faults = [];
    dead_ends = [];
    converges = None;
    growth = None;
    shared = None;
    causes = [];
    left_out = None;
  }

let add a b =
  {
    states = a.states + b.states;
    transitions = a.transitions + b.transitions;
    depth = Int.max a.depth b.depth;
    model_time = Option.merge Rat.max a.model_time b.model_time;
    complete = a.complete && b.complete;
    eventful = a.eventful || b.eventful;
    decided_early = a.decided_early || b.decided_early;
    split_step = (match a.split_step with Some _ -> a.split_step | None -> b.split_step);
    stopped_by = Verdict.together a.stopped_by b.stopped_by;
    faults = List.sort_uniq Scc_base.Diag.compare (a.faults @ b.faults);
    dead_ends = List.sort_uniq Scc_base.Diag.compare (a.dead_ends @ b.dead_ends);
    converges = (match a.converges with Some _ -> a.converges | None -> b.converges);
    growth = (match a.growth with Some _ -> a.growth | None -> b.growth);
    shared = (match a.shared with Some _ -> a.shared | None -> b.shared);
    causes = Growth.together a.causes b.causes;
    left_out = (match a.left_out with Some _ -> a.left_out | None -> b.left_out);
  }
