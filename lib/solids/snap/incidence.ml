type t = { vertices : int; faces : int array array; neighbours : int array array }

let make ~vertices faces =
  let at = Array.make vertices [] in
  Array.iteri (fun f corners -> Array.iter (fun v -> at.(v) <- (vertices + f) :: at.(v)) corners) faces;
  let neighbours =
    Array.init (vertices + Array.length faces) (fun u ->
        if u < vertices then Array.of_list (List.rev at.(u)) else Array.copy faces.(u - vertices))
  in
  { vertices; faces; neighbours }

let size t = Array.length t.neighbours
