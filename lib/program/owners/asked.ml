open Scc_exact
open Scc_ctl

type goal = {
  within : Rat.t option;
  mutable met : Round.event option;
  mutable decided : bool;
  mutable doubtful : bool;
}

let goal within = { within; met = None; decided = false; doubtful = false }
let attained time : Timeline.moment = { offset = Algebraic.of_rat time; attained = true }
let counts (g : goal) time = match g.within with None -> true | Some bound -> Rat.compare time bound <= 0
let asks time g = (not g.decided) && counts g time

(* A goal that was met before is decided by the first state that is not earlier, once its transitions are
   computed. *)
let decide_one (g : goal) now (r : Round.t) (met : Round.event option) =
  let not_later (e : Round.event option) =
    match e with Some e -> Timeline.compare_moment e.moment (attained now) <= 0 | None -> false
  in
  let strictly_earlier (e : Round.event) =
    match g.met with Some known -> Timeline.compare_moment e.moment known.moment < 0 | None -> true
  in
  match r.opened with
  | Some turn when not_later g.met ->
    g.decided <- true;
    Some turn
  | Some _ | None ->
    (match met with Some e when strictly_earlier e -> g.met <- Some e | Some _ | None -> ());
    if not_later g.met then begin
      g.decided <- true;
      Option.map (fun (e : Round.event) -> e.turn) g.met
    end
    else None

let decide goals now (r : Round.t) =
  let one k g = if asks now g then decide_one g now r r.met.(k) else None in
  Array.fold_left (Option.merge Int.max) None (Array.mapi one goals)
