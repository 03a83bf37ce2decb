open Scc_ctl
open Scc_exact
open Naive

type mean = Never_decided | Is of Scc_chance.Answer.t

let direction : Timed_formula.side -> Scc_chance.Equations.direction = function Least -> Min | Greatest -> Max

(* States 0 and 1 are the goal and the failure; each choice has a reward, and what comes of it. *)
let process choices states =
  let open Scc_chance in
  let b = Mdp.builder () in
  let add l =
    ignore (Mdp.add_state b);
    List.iter (fun (reward, branches) -> Mdp.add_choice b ~reward branches) l
  in
  add [ (Rat.zero, [ (0, Rat.one) ]) ];
  add [ (Rat.zero, [ (1, Rat.one) ]) ];
  List.iter (fun s -> add (match choices s with [] -> [ (Rat.zero, [ (1, Rat.one) ]) ] | l -> l)) states;
  let mdp = match Mdp.finish b with Ok m -> m | Error e -> failwith (Mdp.describe e) in
  Qualitative.until (Backwards.make mdp) ~stay:(fun s -> s <> 1) ~goal:(fun s -> s = 0)

let reward_of q side state =
  Scc_chance.(Solution.value (Reward.solve q (direction side) Effort.default ~asked:(States [ state ])) state)

let start t s = 2 + Hashtbl.find t.numbers (Node s)

(* Of all choices of a step: what is earned by each of the jumps, by their order, and by a passing. *)
let ways t x ~jump ~pass ~state =
  let sure earned k' = (earned, [ (state k', Rat.one) ]) in
  let jumps =
    match x.place with
    | Node s when t.small.nodes.(s).drawn && x.jumps <> [] ->
      let node = t.small.nodes.(s) in
      let chances = Small.chances node and drawn, others = Small.split node x.jumps in
      let earned = List.mapi (fun i p -> Rat.mul p (jump i)) chances in
      (List.fold_left Rat.add Rat.zero earned, List.map2 (fun k' p -> (state k', p)) drawn chances)
      :: List.mapi (fun i k' -> sure (jump (i + List.length drawn)) k') others
    | _ -> List.mapi (fun i k' -> sure (jump i) k') x.jumps
  in
  jumps @ List.map (sure pass) x.passes

let until_goal t side ~generous ~jump ~pass g =
  let choices k =
    let x = t.steps.(k) in
    if g.(k) then [ (Rat.zero, [ (0, Rat.one) ]) ]
    else if x.hidden then [ (Rat.zero, [ ((if generous then 0 else 1), Rat.one) ]) ]
    else ways t x ~jump:(jump x) ~pass:(pass x) ~state:(fun k' -> k' + 2)
  in
  reward_of (process choices (List.init (Array.length t.steps) Fun.id)) side (start t 0)

let time_until t side f =
  let pass x = Rat.div (Rat.mul t.small.unit (Rat.of_int x.length)) (Rat.of_int 2) in
  let v = value t f and until_goal = until_goal t side ~jump:(fun _ _ -> Rat.zero) ~pass in
  (until_goal ~generous:true (high v), until_goal ~generous:false (low v))

let counts_until t side count g =
  let v = value t g in
  let jump side_of x i = match x.place with Node s -> Rat.of_int (side_of (count s i)) | _ -> Rat.zero in
  let until_goal side_of = until_goal t side ~jump:(jump side_of) ~pass:(fun _ -> Rat.zero) in
  (until_goal fst ~generous:true (high v), until_goal snd ~generous:false (low v))

(* The time is in halves of the unit. *)
let value_at t side number time =
  let m = time + 1 in
  let offset i = Rat.div (Rat.mul t.small.unit (Rat.of_int (i + 1))) (Rat.of_int 2) in
  let nothing _ = Rat.zero in
  let choices code =
    let k = code / m and c = code mod m in
    let x = t.steps.(k) in
    let goal s o = [ (number s o, [ (0, Rat.one) ]) ] in
    let state c' k' = 2 + (k' * m) + c' in
    let fails = [ (Rat.zero, [ (1, Rat.one) ]) ] in
    match x.place with
    | Node _ when x.hidden -> fails
    | Node s when c = time ->
      let passes = if x.passes <> [] || x.jumps = [] then goal s Rat.zero else [] in
      ways t { x with passes = [] } ~jump:nothing ~pass:Rat.zero ~state:(state c) @ passes
    | Whole (s, i) when x.length = 0 && c = time -> goal s (offset i)
    | Whole (s, i) when x.length > 0 && c + 1 = time -> goal s (offset i)
    | _ when c + x.length > time -> fails
    | _ -> ways t x ~jump:nothing ~pass:Rat.zero ~state:(state (c + x.length))
  in
  let q = process choices (List.init (Array.length t.steps * m) Fun.id) in
  let first = 2 + (Hashtbl.find t.numbers (Node 0) * m) in
  if Scc_data.Bits.mem (Scc_chance.Qualitative.one_min q) first then Is (reward_of q side first) else Never_decided
