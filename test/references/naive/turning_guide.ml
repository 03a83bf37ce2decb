type axis = Face_a of int | Face_b of int | Edges of int * int

type candidate = { axis : axis; reversed : bool; corner_a : int; corner_b : int; gap : float }

type body = {
  corners : float array array;
  faces : int array array;
  centre : float array;
  travel : float array;
  half_spin : float array;
  since : float;
  span : float;
}

type law = Cayley | Uniform

(* One body, and where it is at the time that was asked for last. *)
type placed = {
  body : body;
  normals : float array array;  (* at the start of the turn, of length 1 *)
  links : (int * int * int * int) array;
  x : float array array;
  n : float array array;
  d : float array array;  (* directions of edges *)
  c : float array;
}

type t = { law : law; a : placed; b : placed }

let dot u v = (u.(0) *. v.(0)) +. (u.(1) *. v.(1)) +. (u.(2) *. v.(2))
let sub u v = [| u.(0) -. v.(0); u.(1) -. v.(1); u.(2) -. v.(2) |]

let cross u v =
  [| (u.(1) *. v.(2)) -. (u.(2) *. v.(1)); (u.(2) *. v.(0)) -. (u.(0) *. v.(2));
     (u.(0) *. v.(1)) -. (u.(1) *. v.(0)) |]

let unit v =
  let l = sqrt (dot v v) in
  [| v.(0) /. l; v.(1) /. l; v.(2) /. l |]

let edges faces =
  let found = Hashtbl.create 64 in
  let each f cycle =
    let n = Array.length cycle in
    Array.iteri (fun i v -> Hashtbl.replace found (v, cycle.((i + 1) mod n)) f) cycle
  in
  Array.iteri each faces;
  let add (v, w) f all = if v < w then (v, w, f, Hashtbl.find found (w, v)) :: all else all in
  let compare (a, b, _, _) (c, d, _, _) = if Int.equal a c then Int.compare b d else Int.compare a c in
  Array.of_list (List.sort compare (Hashtbl.fold add found []))

let placed body =
  let normal f =
    let p i = body.corners.(f.(i)) in
    unit (cross (sub (p 1) (p 0)) (sub (p 2) (p 0)))
  in
  let normals = Array.map normal body.faces in
  let links = edges body.faces in
  let blank a = Array.map (fun _ -> [| 0.; 0.; 0. |]) a in
  { body; normals; links; x = blank body.corners; n = blank normals; d = blank links; c = [| 0.; 0.; 0. |] }

let make ?(law = Cayley) a b = { law; a = placed a; b = placed b }

(* The matrix of the quaternion 1 + u, by rows. *)
let matrix u =
  let x = u.(0) and y = u.(1) and z = u.(2) in
  let n = 1. +. dot u u in
  let xx = x *. x and yy = y *. y and zz = z *. z in
  [| (1. +. xx -. yy -. zz) /. n; 2. *. ((x *. y) -. z) /. n; 2. *. ((x *. z) +. y) /. n;
     2. *. ((x *. y) +. z) /. n; (1. -. xx +. yy -. zz) /. n; 2. *. ((y *. z) -. x) /. n;
     2. *. ((x *. z) -. y) /. n; 2. *. ((y *. z) +. x) /. n; (1. -. xx -. yy +. zz) /. n |]

let turn law b t =
  let elapsed = b.since +. (t *. b.span) in
  match law with
  | Cayley -> matrix (Array.map (fun s -> s *. elapsed) b.half_spin)
  | Uniform ->
    (* tan of half the angle that has passed, along the spin. *)
    let s = sqrt (dot b.half_spin b.half_spin) in
    if s = 0. then matrix b.half_spin
    else
      let half = tan (atan (s *. b.span) *. t) in
      matrix (Array.map (fun x -> x /. s *. half) b.half_spin)

let apply m v into =
  let x = v.(0) and y = v.(1) and z = v.(2) in
  into.(0) <- (m.(0) *. x) +. (m.(1) *. y) +. (m.(2) *. z);
  into.(1) <- (m.(3) *. x) +. (m.(4) *. y) +. (m.(5) *. z);
  into.(2) <- (m.(6) *. x) +. (m.(7) *. y) +. (m.(8) *. z)

let place law p t =
  let b = p.body in
  let m = turn law b t in
  for k = 0 to 2 do
    p.c.(k) <- b.centre.(k) +. (t *. b.travel.(k))
  done;
  let corner i v =
    let x = p.x.(i) in
    apply m v x;
    for k = 0 to 2 do
      x.(k) <- x.(k) +. p.c.(k)
    done
  in
  Array.iteri corner b.corners;
  Array.iteri (fun i v -> apply m v p.n.(i)) p.normals

let place_edges p =
  let each i (v, w, _, _) =
    let d = p.d.(i) in
    for k = 0 to 2 do
      d.(k) <- p.x.(w).(k) -. p.x.(v).(k)
    done
  in
  Array.iteri each p.links

(* The corner that is lowest along n. *)
let lowest p n =
  let best = ref 0 and height = ref infinity in
  for i = 0 to Array.length p.x - 1 do
    let h = dot p.x.(i) n in
    if h < !height then (best := i; height := h)
  done;
  (!best, !height)

let over_faces g add =
  let face p i = p.body.faces.(i).(0) in
  Array.iteri
    (fun i n ->
       let a0 = face g.a i in
       let b0, low = lowest g.b n in
       add (Face_a i) false a0 b0 (low -. dot n g.a.x.(a0)))
    g.a.n;
  Array.iteri
    (fun i n ->
       let b0 = face g.b i in
       let a0, low = lowest g.a n in
       add (Face_b i) true a0 b0 (low -. dot n g.b.x.(b0)))
    g.b.n

(* Only pairs of edges whose product carries a facet of the Minkowski difference, with some slack: the arcs of
   their normals cross. Such edges lie highest in A and lowest in B. *)
let over_edges g add =
  let slack = 1e-9 in
  place_edges g.a;
  place_edges g.b;
  Array.iteri
    (fun i (a0, _, f, f') ->
       let d = g.a.d.(i) and n = g.a.n.(f) and n' = g.a.n.(f') in
       Array.iteri
         (fun j (b0, _, h, h') ->
            let e = g.b.d.(j) in
            if dot n e *. dot n' e <= slack then
              let m = g.b.n.(h) and m' = g.b.n.(h') in
              if dot m d *. dot m' d <= slack then
                let axis = cross d e in
                let length = sqrt (dot axis axis) in
                if length > 1e-9 *. sqrt (dot d d *. dot e e) then
                  let s = dot axis n +. dot axis n' in
                  let s' = dot axis m +. dot axis m' in
                  if s *. s' <= slack then
                    let along = dot axis (sub g.b.x.(b0) g.a.x.(a0)) /. length in
                    let reversed = s -. s' < 0. in
                    add (Edges (i, j)) reversed a0 b0 (if reversed then -.along else along))
         g.b.links)
    g.a.links

let place_both g t =
  place g.law g.a t;
  place g.law g.b t

let best g t n =
  place_both g t;
  let kept = ref [] and count = ref 0 and least = ref neg_infinity in
  let add axis reversed corner_a corner_b gap =
    if !count < n || gap > !least then begin
      let rec insert = function
        | c :: rest when c.gap >= gap -> c :: insert rest
        | rest -> { axis; reversed; corner_a; corner_b; gap } :: rest
      in
      kept := List.filteri (fun i _ -> i < n) (insert !kept);
      count := List.length !kept;
      least := (List.nth !kept (!count - 1)).gap
    end
  in
  over_faces g add;
  over_edges g add;
  !kept

let gap g t = (List.hd (best g t 1)).gap

let faces_gap g t =
  place_both g t;
  let widest = ref neg_infinity in
  over_faces g (fun _ _ _ _ gap -> if gap > !widest then widest := gap);
  !widest

(* Samples, then golden sections around the least of them. *)
let least ?(samples = 16) f =
  let at i = float_of_int i /. float_of_int samples in
  let best = ref 0 and value = ref infinity in
  for i = 0 to samples do
    let v = f (at i) in
    if v < !value then (best := i; value := v)
  done;
  let ratio = (sqrt 5. -. 1.) /. 2. in
  let rec narrow lo hi n =
    if n = 0 then (lo +. hi) /. 2.
    else
      let d = ratio *. (hi -. lo) in
      if f (hi -. d) < f (lo +. d) then narrow lo (lo +. d) (n - 1) else narrow (hi -. d) hi (n - 1)
  in
  let t = narrow (at (Int.max 0 (!best - 1))) (at (Int.min samples (!best + 1))) 30 in
  let v = f t in
  if v < !value then (t, v) else (at !best, !value)
