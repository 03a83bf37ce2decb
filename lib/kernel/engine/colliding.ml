open Scc_data
module Firsts = Map.Make (Int)
module First_set = Set.Make (Int)

module Pairs = Map.Make (struct
    type t = int * int

    let compare (a, b) (c, d) =
      let order = Int.compare a c in
      if order <> 0 then order else Int.compare b d
  end)

type 'outcome found = { outcomes : 'outcome list; busy : bool; stops : int list }

type ('body, 'outcome) pair = {
  one : 'body;
  two : 'body;
  mutable ages : int * int;  (** when the following were found *)
  mutable outcomes : 'outcome array;
  mutable busy : bool;
  mutable stops : int list;
}

type ('body, 'outcome) t = {
  first : 'body -> int;
  age : 'body -> int;
  mutable pairs : ('body, 'outcome) pair Pairs.t;  (** by first leaves *)
  partners : First_set.t array;  (** the first leaves of those in whose pairs a body is the second *)
  involved : int array;  (** in how many pairs a body is, by first leaf *)
  counts : Fenwick.t;  (** of outcomes, by the first leaf of the first *)
  mutable unasked : ('body, 'outcome) pair Pairs.t;  (** those whose outcomes are to be found *)
  busy : int array;  (** by first leaf: in how many busy pairs a body is *)
  mutable stopping : ('body, 'outcome) pair Pairs.t;  (** those that stop bodies *)
}

let create leaves ~first ~age =
  {
    first; age;
    pairs = Pairs.empty;
    partners = Array.make leaves First_set.empty;
    involved = Array.make leaves 0;
    counts = Fenwick.create leaves;
    unasked = Pairs.empty;
    busy = Array.make leaves 0;
    stopping = Pairs.empty;
  }

let key t p = (t.first p.one, t.first p.two)

(* Those in which a body is the first, from some place on; and those in which it is the second. *)
let rec with_first leaf pairs () =
  match pairs () with
  | Seq.Cons (((one, _), p), rest) when Int.equal one leaf -> Seq.Cons (p, with_first leaf rest)
  | Seq.Cons _ | Seq.Nil -> Seq.Nil

let as_first t leaf = with_first leaf (Pairs.to_seq_from (leaf, 0) t.pairs)
let as_second t leaf = Seq.map (fun one -> Pairs.find (one, leaf) t.pairs) (First_set.to_seq t.partners.(leaf))

let pairs_of t leaf =
  if t.involved.(leaf) = 0 then Seq.empty else Seq.append (as_first t leaf) (as_second t leaf)

let involve t (one, two) more =
  t.involved.(one) <- t.involved.(one) + more;
  t.involved.(two) <- t.involved.(two) + more

let ask t p = t.unasked <- Pairs.add (key t p) p t.unasked

let meet t one two =
  let p = { one; two; ages = (-1, -1); outcomes = [||]; busy = false; stops = [] } in
  let ((_, second) as key) = key t p in
  if not (Pairs.mem key t.pairs) then begin
    t.pairs <- Pairs.add key p t.pairs;
    involve t key 1;
    t.partners.(second) <- First_set.add (fst key) t.partners.(second);
    ask t p
  end

(* What has been found of a pair takes the place of what had been. *)
let note t p ({ outcomes; busy; stops } : _ found) =
  let ((one, two) as key) = key t p in
  let outcomes = Array.of_list outcomes in
  if Array.length outcomes <> Array.length p.outcomes then
    Fenwick.add t.counts one (Array.length outcomes - Array.length p.outcomes);
  let more = Bool.to_int busy - Bool.to_int p.busy in
  t.busy.(one) <- t.busy.(one) + more;
  t.busy.(two) <- t.busy.(two) + more;
  if stops <> [] then t.stopping <- Pairs.add key p t.stopping
  else if p.stops <> [] then t.stopping <- Pairs.remove key t.stopping;
  p.outcomes <- outcomes;
  p.busy <- busy;
  p.stops <- stops

let forget t p =
  let ((one, two) as key) = key t p in
  note t p { outcomes = []; busy = false; stops = [] };
  t.partners.(two) <- First_set.remove one t.partners.(two);
  t.pairs <- Pairs.remove key t.pairs;
  involve t key (-1);
  t.unasked <- Pairs.remove key t.unasked

(* They are listed before the first one goes. *)
let part t leaf = List.iter (forget t) (List.of_seq (pairs_of t leaf))
let changed t leaf = Seq.iter (ask t) (pairs_of t leaf)

let find t outcomes =
  let find _ p =
    let one, two = (t.age p.one, t.age p.two) in
    let known = match p.ages with a, b -> a = one && b = two in
    if not known then begin
      note t p (outcomes p.one p.two);
      p.ages <- (one, two)
    end
  in
  Pairs.iter find t.unasked;
  t.unasked <- Pairs.empty

let count t = Fenwick.total t.counts

let nth t k =
  let leaf, k = Fenwick.find t.counts k in
  let rec from k pairs =
    match pairs () with
    | Seq.Nil -> Scc_base.Bug.fail __POS__ "outcomes are counted of pairs that have none"
    | Seq.Cons (p, rest) ->
      let n = Array.length p.outcomes in
      if k < n then p.outcomes.(k) else from (k - n) rest
  in
  from k (as_first t leaf)

let stopping t =
  let add _ p firsts = List.filter (fun first -> t.busy.(first) = 0) p.stops @ firsts in
  List.sort_uniq Int.compare (Pairs.fold add t.stopping [])

let bodies t =
  let add body all = Firsts.add (t.first body) body all in
  let all = Pairs.fold (fun _ p all -> add p.one (add p.two all)) t.pairs Firsts.empty in
  List.map snd (Firsts.bindings all)
