type t = { points : float array; planes : float array }

(* A processor that multiplies and adds in one step would round otherwise, and find another solid. *)
let ( *! ) a b = Sys.opaque_identity (a *. b)

let dot a i b j = (a.(i) *! b.(j)) +. (a.(i + 1) *! b.(j + 1)) +. (a.(i + 2) *! b.(j + 2))

(* {1 First planes: Newell's method} *)

let plane points corners =
  let n = Array.length corners in
  let mean k = Array.fold_left (fun s v -> s +. points.((3 * v) + k)) 0. corners /. float_of_int n in
  let c = [| mean 0; mean 1; mean 2 |] in
  let at i k = points.((3 * corners.(i mod n)) + k) -. c.(k) in
  let normal = [| 0.; 0.; 0. |] in
  for i = 0 to n - 1 do
    let add k a b =
      normal.(k) <- normal.(k) +. (at i a *! at (i + 1) b) -. (at i b *! at (i + 1) a)
    in
    add 0 1 2;
    add 1 2 0;
    add 2 0 1
  done;
  let height = dot normal 0 c 0 in
  if height > 0. then Some (Array.map (fun x -> x /. height) normal) else None

let planes points faces =
  let all = Array.map (plane points) faces in
  match Array.find_opt Option.is_none all with
  | Some _ -> None
  | None -> Some (Array.concat (List.map Option.get (Array.to_list all)))

(* {1 Pairs of a vertex and a face} *)

type pair = { v : int; f : int }

(* Breadth first, so that pairs that share a vertex or a face stand near each other. *)
let in_order (i : Incidence.t) =
  let all = Array.concat (Array.to_list (Array.mapi (fun f c -> Array.map (fun v -> { v; f }) c) i.faces)) in
  let seen = Array.make (Incidence.size i) false in
  let queue = Queue.create () and order = ref [] in
  let number = Array.make (Incidence.size i) 0 and next = ref 0 in
  let visit u =
    if not seen.(u) then begin
      seen.(u) <- true;
      number.(u) <- !next;
      incr next;
      Queue.add u queue
    end
  in
  for u = 0 to Incidence.size i - 1 do
    visit u;
    while not (Queue.is_empty queue) do
      let u = Queue.pop queue in
      order := u :: !order;
      Array.iter visit i.neighbours.(u)
    done
  done;
  let key p =
    let a = number.(p.v) and b = number.(i.vertices + p.f) in
    (Int.max a b, Int.min a b)
  in
  let compare p q =
    let (a, b), (c, d) = (key p, key q) in
    if a <> c then Int.compare a c else Int.compare b d
  in
  Array.stable_sort compare all;
  all

let first_of pairs =
  let at_vertex = Hashtbl.create 64 and at_face = Hashtbl.create 64 in
  let least table (key : int) k =
    match Hashtbl.find_opt table key with
    | Some first -> first
    | None ->
      Hashtbl.add table key k;
      k
  in
  Array.mapi (fun k p -> Int.min (least at_vertex p.v k) (least at_face p.f k)) pairs

(* {1 One step} *)

(* The rows of the lower triangle of a symmetric matrix from their first entry that is not 0; replaced by those of
   its root (Cholesky). *)
let cholesky first rows =
  let n = Array.length rows in
  let rec row i =
    if i = n then true
    else begin
      let r = rows.(i) and from = first.(i) in
      for j = from to i - 1 do
        let q = rows.(j) and from' = first.(j) in
        let s = ref r.(j - from) in
        for k = Int.max from from' to j - 1 do
          s := !s -. (r.(k - from) *! q.(k - from'))
        done;
        r.(j - from) <- !s /. q.(j - from')
      done;
      let s = ref r.(i - from) in
      for k = from to i - 1 do
        s := !s -. (r.(k - from) *! r.(k - from))
      done;
      if !s > 0. then begin
        r.(i - from) <- sqrt !s;
        row (i + 1)
      end
      else false
    end
  in
  row 0

let solve first rows b =
  let n = Array.length rows in
  let x = Array.copy b in
  for i = 0 to n - 1 do
    for k = first.(i) to i - 1 do
      x.(i) <- x.(i) -. (rows.(i).(k - first.(i)) *! x.(k))
    done;
    x.(i) <- x.(i) /. rows.(i).(i - first.(i))
  done;
  for i = n - 1 downto 0 do
    x.(i) <- x.(i) /. rows.(i).(i - first.(i));
    for k = first.(i) to i - 1 do
      x.(k) <- x.(k) -. (rows.(i).(k - first.(i)) *! x.(i))
    done
  done;
  x

let residuals t pairs = Array.map (fun p -> 1. -. dot t.points (3 * p.v) t.planes (3 * p.f)) pairs

(* How freely a plane moves, beside a vertex: so much more that vertices move as if planes were free; in proportion
   to the square of its distance from the origin, so that this is the same for all planes. *)
let freedom = 1e4

let step t ~ease pairs first =
  let loose =
    Array.init (Array.length t.planes / 3) (fun f ->
        let n2 = dot t.planes (3 * f) t.planes (3 * f) in
        freedom *! (n2 *! n2))
  in
  let entry p q =
    let by_face = if p.f = q.f then loose.(p.f) *! dot t.points (3 * p.v) t.points (3 * q.v) else 0. in
    let by_vertex =
      if p.v <> q.v then 0.
      else
        let term k = ease.(k) *! (t.planes.((3 * p.f) + k) *! t.planes.((3 * q.f) + k)) in
        term 0 +. term 1 +. term 2
    in
    by_face +. by_vertex
  in
  let row i p = Array.init (i - first.(i) + 1) (fun k -> entry p pairs.(first.(i) + k)) in
  let rows = Array.mapi row pairs in
  if not (cholesky first rows) then None
  else begin
    let x = solve first rows (residuals t pairs) in
    let points = Array.copy t.points and planes = Array.copy t.planes in
    Array.iteri
      (fun i p ->
         for k = 0 to 2 do
           let v = (3 * p.v) + k and f = (3 * p.f) + k in
           points.(v) <- points.(v) +. (ease.(k) *! (x.(i) *! t.planes.(f)));
           planes.(f) <- planes.(f) +. (loose.(p.f) *! (x.(i) *! t.points.(v)))
         done)
      pairs;
    Some { points; planes }
  end

(* {1 All steps} *)

let worst t pairs = Array.fold_left (fun w r -> Float.max w (Float.abs r)) 0. (residuals t pairs)
let most_steps = 8
let most_work = 5e8

let work first =
  let square k from = let w = float_of_int (k - from) in w *. w in
  let sum = ref 0. in
  Array.iteri (fun k from -> sum := !sum +. square k from) first;
  !sum

type failure = Inside_out | Too_large

let polish (i : Incidence.t) ~ease points =
  let pairs = in_order i in
  let first = first_of pairs in
  if work first > most_work then Error Too_large
  else
    match planes points i.faces with
    | None -> Error Inside_out
    | Some planes ->
      let rec go t now n =
        if n = 0 || now < 4e-16 then t
        else
          match step t ~ease pairs first with
          | None -> t
          | Some next ->
            let then_ = worst next pairs in
            (* it gets no better than the last digits allow *)
            if then_ < now then go next then_ (n - 1) else t
      in
      let t = { points; planes } in
      Ok (go t (worst t pairs) most_steps)
