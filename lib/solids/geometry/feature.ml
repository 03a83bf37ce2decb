type t = Vertex of int | Edge of int | Face of int

let dimension = function Vertex _ -> 0 | Edge _ -> 1 | Face _ -> 2
let index = function Vertex i | Edge i | Face i -> i
let equal a b = dimension a = dimension b && index a = index b

let compare a b =
  Int.compare (dimension a) (dimension b) <?> fun () -> Int.compare (index a) (index b)

let hash f = (index f * 3) + dimension f
