(* Positions of the cycle are 0 … n-1. A chord is an edge, or a diagonal with a reflex end (a diagonal between two
   corners that are not reflex can always be left out). Of a chord (i, k), i < k, [least] is the least number of
   convex pieces of the polygon i, i+1, …, k; it is 0 of an edge.

   The piece at the chord (i, k) is a chain of chords i = v0, v1, …, vm = k that turns nowhere to the right, with
   the chord back. For one i, [cost] of a chord (a, b) is the least sum of [least] over the chains from i whose
   last chord it is, and [first] the greatest v1 of those: the narrowest at i. One that costs more need not be
   kept: it is no better than the chain that begins with the chord (i, a), and has this diagonal as another cut.
   All of a chain is left of its first chord, and i is left of all others, so that it winds around i less than
   half a turn: no right turns, also at its ends, make it convex.

   Chains that end at b are [live] if they may go on. None may where the segment from i to b leaves the polygon,
   since a convex piece contains it. Where (i, b) is a chord, a chain that goes on costs less than the chord.
   The reason: whatever follows the chain may follow the chord (i, b), which is a chain of its own. The angle at b
   is smaller then, as i is before the start of the last chord, and the chord is narrower at i. A way back from b
   along the segment to i, where the chord would end, does not exist, as no corner is on the segment. *)

type t = {
  g : Grid.t;
  at : int array;
  into : int array array;  (* for each b the numbers of the chords (a, b), a < b, in the order of a *)
  start : int array;  (* by chord: a *)
  closed : Bytes.t array;  (* for each b, by a < b: '\001' if a convex piece cannot have both as corners *)
  least : int array;  (* by chord *)
  cost : int array;
  first : int array;
  before : int array;  (* the chord before the last one of the chain; -1 for none *)
  live : int array array;  (* for each b those of [into] with a chain from the i at hand, in that order *)
  lives : int array;  (* how many *)
}

let never = max_int / 4

(* The chords into each position and the starts of all; what is closed. *)
let chords (c : Cycle.t) =
  let n = Array.length c.at in
  let reflex = Array.init n (Cycle.reflex c) in
  let is_edge a b = b = a + 1 || (a = 0 && b = n - 1) in
  let closed = Array.init n (fun b -> Bytes.make b '\000') and starts = Scc_data.Growable.create () in
  let number a =
    Scc_data.Growable.push starts a;
    Scc_data.Growable.length starts - 1
  in
  let is_chord b a =
    is_edge a b
    ||
    match Cycle.view c a b with
    | Open -> reflex.(a) || reflex.(b)
    | Along -> false
    | Closed ->
      Bytes.set closed.(b) a '\001';
      false
  in
  let into b = Array.of_list (List.map number (List.filter (is_chord b) (List.init b Fun.id))) in
  let into = Array.init n into in
  (into, Array.init (Scc_data.Growable.length starts) (Scc_data.Growable.get starts), closed)

let orient t a b c = Grid.orient t.g t.at.(a) t.at.(b) t.at.(c)
let turns t a b c = Grid.turns t.g t.at.(a) t.at.(b) t.at.(c)

(* The place in [into] of the first chord that does not begin before i. *)
let first_from t (list : int array) i =
  let rec between low high =
    if low >= high then low
    else
      let middle = (low + high) / 2 in
      if t.start.(list.(middle)) < i then between (middle + 1) high else between low middle
  in
  between 0 (Array.length list)

(* The best chain from i that ends with the chord from a to b, i < a. *)
let extend t i b chord =
  t.cost.(chord) <- never;
  let a = t.start.(chord) in
  let count = t.lives.(a) in
  if count > 0 && orient t a b i >= 0 && not (Grid.same t.g t.at.(b) t.at.(i)) then begin
    let live = t.live.(a) and own = t.least.(chord) in
    for k = 0 to count - 1 do
      let last = live.(k) in
      let cost = t.cost.(last) + own and first = t.first.(last) in
      let better = cost < t.cost.(chord) || (cost = t.cost.(chord) && first > t.first.(chord)) in
      if better && turns t t.start.(last) a b && orient t i first b >= 0 then begin
        t.cost.(chord) <- cost;
        t.first.(chord) <- first;
        t.before.(chord) <- last
      end
    done
  end

(* The last chord of the best piece at the chord (i, b), and what it costs. *)
let close t i b =
  let best (found, cost) chord =
    let a = t.start.(chord) in
    if a > i && t.cost.(chord) < cost && turns t a b i && turns t b i t.first.(chord) then (chord, t.cost.(chord))
    else (found, cost)
  in
  Array.fold_left best (-1, never) t.into.(b)

(* Those chords into b go on whose chains cost less than [most]. *)
let keep t b ~from ~most =
  let into = t.into.(b) and count = ref 0 in
  for k = from to Array.length into - 1 do
    if t.cost.(into.(k)) < most then begin
      t.live.(b).(!count) <- into.(k);
      incr count
    end
  done;
  t.lives.(b) <- !count

(* All chains from i, up to the position [upto]; what closes the piece there. *)
let chains t i ~upto =
  let closing = ref (-1) in
  for b = i + 1 to upto do
    let into = t.into.(b) in
    let k = first_from t into i in
    let chord = if k < Array.length into && t.start.(into.(k)) = i then into.(k) else -1 in
    if b > i + 1 && Bytes.get t.closed.(b) i = '\001' then t.lives.(b) <- 0
    else begin
      let next = if chord < 0 then k else k + 1 in
      for l = next to Array.length into - 1 do
        extend t i b into.(l)
      done;
      if chord < 0 then keep t b ~from:next ~most:never
      else begin
        let last, cost = close t i b in
        closing := last;
        if b > i + 1 then t.least.(chord) <- (if cost < never then cost + 1 else never);
        keep t b ~from:next ~most:(Int.min never t.least.(chord));
        t.cost.(chord) <- t.least.(chord);
        t.first.(chord) <- b;
        t.before.(chord) <- -1;
        if t.least.(chord) < never then begin
          t.live.(b).(t.lives.(b)) <- chord;
          t.lives.(b) <- t.lives.(b) + 1
        end
      end
    end
  done;
  !closing

(* The positions of the chain that ends with a chord, in their order; [upto] is the last one. *)
let chain t ~upto last =
  let rec back chord found =
    let found = t.start.(chord) :: found in
    if t.before.(chord) < 0 then found else back t.before.(chord) found
  in
  back last [ upto ]

let pieces (c : Cycle.t) =
  let n = Array.length c.at in
  let into, start, closed = chords c in
  let zeros () = Array.make (Array.length start) 0 in
  let t =
    { g = c.grid; at = c.at; into; start; closed; least = zeros (); cost = zeros (); first = zeros ();
      before = zeros (); live = Array.map (fun into -> Array.make (Array.length into) 0) into;
      lives = Array.make n 0 }
  in
  for i = n - 1 downto 0 do
    ignore (chains t i ~upto:(n - 1))
  done;
  let rec cut found = function
    | [] -> found
    | (i, k) :: rest ->
      let last = chains t i ~upto:k in
      if last < 0 then Scc_base.Bug.fail __POS__ "a polygon without a partition";
      let positions = chain t ~upto:k last in
      let inner = List.filter (fun (a, b) -> b <> a + 1) (Scc_data.Lists.neighbours positions) in
      cut (Array.of_list (List.map (fun p -> c.at.(p)) positions) :: found) (inner @ rest)
  in
  cut [] [ (0, n - 1) ]
