open Scc_exact

type kind = Refine.kind = Strong | Branching | Weak
type outcome = Differ of Modal_formula.t option | Alike | Too_large

let most_pairs = 400_000
let most_parts = 2_000
let to_decide = 1_000_000_000
let to_explain = 50_000_000

(* Of the evaluations that keep a formula short. *)
let most_steps = 1_000_000

type step = Action of int | Time of Rat.t

type pair = {
  one : System.position;
  two : System.position;
  mutable why : why option;  (* once they are known to differ *)
  mutable watchers : pair list;  (* to be looked at again when these differ *)
}

(* The winning move, and when it was found: it rests on earlier ones alone. *)
and why = { by_one : bool; step : step; into : System.position; time : int }

type t = {
  effort : Effort.t;
  kind : kind;
  m : System.t;
  same : System.position -> System.position -> bool;
  pairs : (int * int, pair) Hashtbl.t;
  queue : pair Queue.t;  (* pairs never looked at *)
  again : pair Stack.t;
  mutable clock : int;
  mutable left : int;  (* questions about pairs that may still be asked *)
}

exception Limit

(* {1 Pairs} *)

let find t p q =
  let key = if p <= q then (p, q) else (q, p) in
  match Hashtbl.find_opt t.pairs key with
  | Some pair -> pair
  | None ->
    if Hashtbl.length t.pairs >= most_pairs then raise Limit;
    let pair = { one = fst key; two = snd key; why = None; watchers = [] } in
    Hashtbl.add t.pairs key pair;
    Queue.add pair t.queue;
    pair

let are_same t p q =
  t.left <- t.left - 1;
  if t.left < 0 then raise Limit;
  p = q || t.same p q

(* Whether the two are known to differ; if not, [watcher] will hear of it. *)
let differ t watcher p q =
  (not (are_same t p q))
  &&
  let pair = find t p q in
  Option.is_some pair.why
  || begin
    (match pair.watchers with
     | last :: _ when last == watcher -> ()
     | _ -> if pair != watcher then pair.watchers <- watcher :: pair.watchers);
    false
  end

(* [p] differs from all of them. An answer that can never differ spares the others. *)
let differs_from_all t watcher p answers =
  (not (List.exists (are_same t p) answers)) && List.for_all (differ t watcher p) answers

let all_known t = List.for_all (System.known t.m)

(* {1 Moves} *)

let weak_answers t defender a =
  let before = System.silent_closure t.m [ defender ] in
  if Graph.is_tau a then (before, before)
  else (before, System.silent_closure t.m (List.concat_map (fun p -> System.after t.m p a) before))

(* Whether the defender has no answer to the action. *)
let action_wins t pair ~attacker ~defender a into =
  match t.kind with
  | Strong ->
    System.known t.m defender && differs_from_all t pair into (System.after t.m defender a)
  | Weak ->
    let before, answers = weak_answers t defender a in
    all_known t before && differs_from_all t pair into answers
  | Branching ->
    let no_answer_from p =
      (System.known t.m p && differs_from_all t pair into (System.after t.m p a))
      || differ t pair attacker p
    in
    ((not (Graph.is_tau a)) || differ t pair into defender)
    && List.for_all no_answer_from (System.silent_closure t.m [ defender ])

let winning_action t pair ~attacker ~defender =
  let found = ref None in
  System.actions t.m attacker (fun a into ->
      Effort.spend t.effort 1;
      if Option.is_none !found && action_wins t pair ~attacker ~defender a into then
        found := Some (Action a, into));
  !found

let winning_wait t pair ~attacker ~defender =
  match System.patience t.m attacker with
  | Never -> None
  | _ when not (System.known t.m defender) -> None
  | patience -> (
      match System.common patience (System.patience t.m defender) with
      | None -> None
      | Some d ->
        let answers = System.wait t.m defender d in
        let wins into = differs_from_all t pair into answers in
        Option.map (fun into -> (Time d, into)) (List.find_opt wins (System.wait t.m attacker d)))

let winning t pair ~attacker ~defender =
  match winning_action t pair ~attacker ~defender with
  | None -> winning_wait t pair ~attacker ~defender
  | found -> found

let look t pair =
  if Option.is_none pair.why then begin
    Effort.spend t.effort 10;
    let found =
      match winning t pair ~attacker:pair.one ~defender:pair.two with
      | Some (step, into) -> Some (true, step, into)
      | None ->
        winning t pair ~attacker:pair.two ~defender:pair.one
        |> Option.map (fun (step, into) -> (false, step, into))
    in
    match found with
    | None -> ()
    | Some (by_one, step, into) ->
      pair.why <- Some { by_one; step; into; time = t.clock };
      t.clock <- t.clock + 1;
      List.iter (fun w -> Stack.push w t.again) pair.watchers;
      pair.watchers <- []
  end

let rec decide t root =
  if Option.is_some root.why then true
  else if not (Stack.is_empty t.again) then begin
    look t (Stack.pop t.again);
    decide t root
  end
  else if not (Queue.is_empty t.queue) then begin
    look t (Queue.pop t.queue);
    decide t root
  end
  else false

(* {1 The formula} *)

type writer = {
  game : t;
  store : Modal_formula.store;
  truth : Modal_formula.evaluator;
  written : (int * int, Modal_formula.t) Hashtbl.t;
  mutable parts : int;  (* written or begun *)
}

let differed_before w time p q =
  (not (are_same w.game p q))
  &&
  match Hashtbl.find_opt w.game.pairs (if p <= q then (p, q) else (q, p)) with
  | Some { why = Some why; _ } -> why.time < time
  | _ -> false

(* Certainly true of [p] and certainly false of [q], which are known to differ. The recursion ends since winning
   moves rest on earlier ones, and is no deeper than [most_parts]. *)
let rec tell w p q =
  match Hashtbl.find_opt w.written (p, q) with
  | Some f -> f
  | None ->
    if w.parts >= most_parts then raise Limit;
    w.parts <- w.parts + 1;
    let pair = find w.game p q in
    let why = Option.get pair.why in
    let attacker, defender = if why.by_one then (pair.one, pair.two) else (pair.two, pair.one) in
    let f = move w why ~attacker ~defender in
    let f = if attacker = p then f else Modal_formula.negation w.store f in
    Hashtbl.replace w.written (p, q) f;
    f

(* True of [p], false of each of the others. *)
and tell_all w p others =
  let add parts q =
    let told = List.exists (fun f -> not (Modal_formula.possibly w.truth f q)) parts in
    if told then parts else tell w p q :: parts
  in
  Modal_formula.conjunction w.store (List.rev (List.fold_left add [] others))

and move w why ~attacker ~defender =
  let m = w.game.m in
  match (why.step, w.game.kind) with
  | Time d, _ ->
    Modal_formula.can w.store (Modal_formula.Wait d) (tell_all w why.into (System.wait m defender d))
  | Action a, Strong -> Modal_formula.can w.store (Now a) (tell_all w why.into (System.after m defender a))
  | Action a, Weak ->
    Modal_formula.can w.store (Weakly a) (tell_all w why.into (snd (weak_answers w.game defender a)))
  | Action a, Branching ->
    let closure = System.silent_closure m [ defender ] in
    let told_after p =
      System.known m p && List.for_all (differed_before w why.time why.into) (System.after m p a)
    in
    let by_after, by_before = List.partition told_after closure in
    let answers = List.concat_map (fun p -> System.after m p a) by_after in
    let answers = if Graph.is_tau a then defender :: answers else answers in
    Modal_formula.until w.store (tell_all w attacker by_before) a (tell_all w why.into answers)

let play effort kind m ~most ~same store p q =
  let t =
    {
      effort;
      kind;
      m;
      same;
      pairs = Hashtbl.create 1024;
      queue = Queue.create ();
      again = Stack.create ();
      clock = 0;
      left = most;
    }
  in
  if p = q || same p q then Alike
  else
    match decide t (find t p q) with
    | exception Limit -> Too_large
    | false -> Alike
    | true -> (
        let truth = Modal_formula.evaluator ~most:most_steps m in
        let w = { game = t; store; truth; written = Hashtbl.create 64; parts = 0 } in
        match tell w p q with
        | f -> Differ (Some f)
        | exception (Limit | Modal_formula.Too_much) -> Differ None)
