open Scc_exact

type t = { cuts : Algebraic.t array; cells : Bytes.t }

let yes = { cuts = [||]; cells = Bytes.make 1 '\001' }
let no = { cuts = [||]; cells = Bytes.make 1 '\000' }
let constant v = if v then yes else no
let is_constant p = Array.length p.cuts = 0
let code v = if v then '\001' else '\000'
let cells p = Bytes.length p.cells
let holds p i = not (Char.equal (Bytes.get p.cells i) '\000')
let is_point i = i land 1 = 1
let low p i = if i = 0 then Algebraic.zero else p.cuts.((i - 1) / 2)
let high p i = if i / 2 < Array.length p.cuts then Some p.cuts.(i / 2) else None

let equal p q =
  Bytes.equal p.cells q.cells
  && Array.length p.cuts = Array.length q.cuts
  && (let rec same i =
        i = Array.length p.cuts || (Algebraic.equal p.cuts.(i) q.cuts.(i) && same (i + 1))
      in
      same 0)

let not_ p =
  if is_constant p then constant (not (holds p 0))
  else { p with cells = Bytes.map (fun c -> code (Char.equal c '\000')) p.cells }

(* From the cuts with the values at and after each, in reverse; cuts at which nothing changes are left out. *)
let make first pieces =
  let keep (before, acc) (cut, at, after) =
    if Bool.equal before at && Bool.equal at after then (before, acc)
    else (after, (cut, at, after) :: acc)
  in
  let _, kept = List.fold_left keep (first, []) (List.rev pieces) in
  match kept with
  | [] -> constant first
  | _ :: _ ->
    let kept = Array.of_list (List.rev kept) in
    let value i =
      if i = 0 then first
      else
        let _, at, after = kept.((i - 1) / 2) in
        if is_point i then at else after
    in
    {
      cuts = Array.map (fun (cut, _, _) -> cut) kept;
      cells = Bytes.init ((2 * Array.length kept) + 1) (fun i -> code (value i));
    }

let of_pieces first pieces = make first (List.rev pieces)

let of_timeline test (t : _ Timeline.t) =
  let piece (p : _ Timeline.piece) = (p.cut, test p.at, test p.after) in
  match t.rest with
  | [] -> constant (test t.first)
  | rest -> make (test t.first) (List.rev_map piece rest)

let inside low = function
  | Some high -> Algebraic.between low high
  | None -> Rat.add Rat.one (snd (Algebraic.enclose low ~width:Rat.one))

let build ~limit cuts f =
  let counts c =
    Algebraic.compare_rat c Rat.zero > 0
    && match limit with None -> true | Some l -> Algebraic.compare c l < 0
  in
  let cuts = List.sort_uniq Algebraic.compare (List.filter counts cuts) in
  let between low = function
    | [] -> f (Algebraic.of_rat (inside low limit))
    | next :: _ -> f (Algebraic.of_rat (inside low (Some next)))
  in
  let rec go acc = function
    | [] -> acc
    | c :: later -> go ((c, f c, between c later) :: acc) later
  in
  make (between Algebraic.zero cuts) (go [] cuts)

let find p offset =
  let rec go i =
    if i = Array.length p.cuts then 2 * i
    else
      let c = Algebraic.compare offset p.cuts.(i) in
      if c < 0 then 2 * i else if c = 0 then (2 * i) + 1 else go (i + 1)
  in
  go 0

let at p offset = if is_constant p then holds p 0 else holds p (find p offset)

type pair = { left : t; right : t }

let common p q =
  let rec go i j acc =
    if i = Array.length p.cuts && j = Array.length q.cuts then Array.of_list (List.rev acc)
    else if i = Array.length p.cuts then go i (j + 1) (q.cuts.(j) :: acc)
    else if j = Array.length q.cuts then go (i + 1) j (p.cuts.(i) :: acc)
    else
      let c = Algebraic.compare p.cuts.(i) q.cuts.(j) in
      if c < 0 then go (i + 1) j (p.cuts.(i) :: acc)
      else if c > 0 then go i (j + 1) (q.cuts.(j) :: acc)
      else go (i + 1) (j + 1) (p.cuts.(i) :: acc)
  in
  go 0 0 []

(* The same on more cuts, among which its own are. *)
let spread p cuts =
  let cells = Bytes.make ((2 * Array.length cuts) + 1) '\000' in
  let own = ref 0 in
  Array.iteri
    (fun k cut ->
       Bytes.set cells (2 * k) (Bytes.get p.cells (2 * !own));
       let met = !own < Array.length p.cuts && Algebraic.equal cut p.cuts.(!own) in
       Bytes.set cells ((2 * k) + 1) (Bytes.get p.cells ((2 * !own) + if met then 1 else 0));
       if met then incr own)
    cuts;
  Bytes.set cells (2 * Array.length cuts) (Bytes.get p.cells (2 * !own));
  { cuts; cells }

let pair p q =
  if is_constant p && is_constant q then { left = p; right = q }
  else
    let cuts = common p q in
    { left = spread p cuts; right = spread q cuts }

let map2 f p q =
  if is_constant p && is_constant q then constant (f (holds p 0) (holds q 0))
  else
    let { left; right } = pair p q in
    let value i = f (holds left i) (holds right i) in
    let n = Array.length left.cuts in
    let rec go k acc =
      if k = n then acc else go (k + 1) ((left.cuts.(k), value ((2 * k) + 1), value ((2 * k) + 2)) :: acc)
    in
    make (value 0) (go 0 [])
