let is _ = false
let read ~resolution:_ ~path _ = Picture_fault.unsupported ~path "not yet"
