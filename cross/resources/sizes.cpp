// One array for each type that a program holds in RAM, of the type's size, which is read from the symbols. Of
// types that may be static objects one such object as well: if not all of its initial values are 0, it is in
// flash, too.
#include "osem/osem.hpp"

#define OSEM_SIZE(name) unsigned char size_of_##name[sizeof(osem::name)]
#define OSEM_OBJECT(name)                                                                                    \
    OSEM_SIZE(name);                                                                                         \
    osem::name object_of_##name

OSEM_SIZE(Node);
OSEM_SIZE(NodePool);
OSEM_SIZE(Edge);
OSEM_SIZE(Octree);
OSEM_OBJECT(TreeBuilder);
OSEM_OBJECT(Conversion);
OSEM_OBJECT(GridConversion);
OSEM_OBJECT(Labelling);
OSEM_OBJECT(Fitting);
OSEM_OBJECT(Pruning);
OSEM_OBJECT(Appraisal);
OSEM_OBJECT(Combination);
OSEM_OBJECT(StreamReader);
OSEM_OBJECT(StreamBuilder);
OSEM_OBJECT(StreamCursor);
OSEM_OBJECT(StreamCombination);
OSEM_OBJECT(CsgConversion);
OSEM_SIZE(CsgSolid);
OSEM_SIZE(CsgTree);
OSEM_SIZE(CsgStream);
OSEM_OBJECT(ClusterWalk);
OSEM_OBJECT(SurfaceMeasurement);
OSEM_OBJECT(Boundary);
OSEM_SIZE(BoundaryCorner);
OSEM_OBJECT(ComponentLabelling);
OSEM_SIZE(Component);
OSEM_SIZE(SegmentWalk);
OSEM_SIZE(NeighbourWalk);
OSEM_OBJECT(Collision);
OSEM_SIZE(NodeWalk);
OSEM_SIZE(LeafWalk);
OSEM_OBJECT(Translation);
OSEM_OBJECT(Reorientation);
OSEM_OBJECT(Coarsening);
OSEM_OBJECT(RowWalk);
OSEM_OBJECT(RunSlicing);
OSEM_OBJECT(BitmapSlicing);
